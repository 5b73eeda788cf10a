import type { Hairstyle } from "../api/contract";
import type { galleryText } from "../text/galleryText";
import bob from "../../gallery/bob.json?raw";
import bobPicture from "../../gallery/bob.webp";
import hime from "../../gallery/hime.json?raw";
import himePicture from "../../gallery/hime.webp";
import ponytail from "../../gallery/ponytail.json?raw";
import ponytailPicture from "../../gallery/ponytail.webp";
import spiky from "../../gallery/spiky.json?raw";
import spikyPicture from "../../gallery/spiky.webp";
import twintails from "../../gallery/twintails.json?raw";
import twintailsPicture from "../../gallery/twintails.webp";
import waves from "../../gallery/waves.json?raw";
import wavesPicture from "../../gallery/waves.webp";

export interface GalleryEntry {
  readonly name: keyof typeof galleryText.en.names;
  /** Address of its picture, 240 by 280 pixels. */
  readonly picture: string;
  readonly hairstyle: Hairstyle;
}

// Raw, since the types of JSON know no tuples. They were saved by the page itself, and a test compares them with the contract.
const entry = (name: GalleryEntry["name"], picture: string, text: string): GalleryEntry => ({ name, picture, hairstyle: JSON.parse(text) as Hairstyle });

/** The hairstyles that come with the page, part of it, so that they are there when the service is not. */
export const gallery: readonly GalleryEntry[] = [
  entry("bob", bobPicture, bob),
  entry("hime", himePicture, hime),
  entry("twintails", twintailsPicture, twintails),
  entry("ponytail", ponytailPicture, ponytail),
  entry("spiky", spikyPicture, spiky),
  entry("waves", wavesPicture, waves),
];
