import { Vector3, type Group, type Ray } from "three";
import { Signal } from "../base/Signal";
import type { FillPreview } from "../fill/FillPreview";
import { HairView } from "../hair/HairView";
import type { Player } from "../motion/Player";
import { hairTones } from "../paint/hairTones";
import { headScale } from "../model/headScale";
import type { PaintedHead } from "../paint/PaintedHead";
import type { Mode, Studio } from "../Studio";
import { language } from "../text/language";
import { stageText } from "../text/stageText";
import { DrawTool } from "./DrawTool";
import { FillTool } from "./FillTool";
import { GhostView } from "./GhostView";
import { HeadSurface } from "./HeadSurface";
import type { Scene } from "./Scene";
import { ShapeTool } from "./ShapeTool";
import type { Tool } from "./Tool";
import { Viewport, type View } from "./Viewport";
import { WindTool } from "./WindTool";

// Metres, on a head of the bundled one's size.
const kHeight = 0.46; // of the picture
const kMiddle = -0.02; // of the picture, above the head's center
const kLit = 0.3; // around the head

/** The picture with everything in it: the head, its hair, what may come, and the tool of the mode. */
export class HairStage implements Scene {
  readonly viewport: Viewport;
  readonly head: Signal<HeadSurface>;
  readonly hair: HairView;
  /** What playback shows. */
  readonly frame = new Signal(0);
  readonly picture = new Signal(0);
  readonly draw: DrawTool;
  private readonly ghost: GhostView;
  private readonly tools: Readonly<Record<Mode, Tool>>;

  constructor(private readonly studio: Studio, preview: FillPreview, private readonly player: Player, private painted: PaintedHead) {
    const words = () => stageText[language.value];
    this.viewport = new Viewport(words().picture);
    studio.scalp.value = painted.scalp;
    this.head = new Signal(new HeadSurface(painted.surface));
    this.hair = new HairView(studio.document.color);
    this.ghost = new GhostView(studio.document.color);
    this.viewport.stage.scene.add(painted.group, this.hair.group, this.ghost.group);
    this.draw = new DrawTool(studio, this, words);
    this.tools = { draw: this.draw, shape: new ShapeTool(studio, this, words), fill: new FillTool(studio, this), move: new WindTool(studio, this, words) };
    this.viewport.onFrame = () => this.tick();
    this.viewport.onDraw = () => this.paint();
    studio.mode.follow((mode) => this.viewport.use(this.tools[mode]));
    studio.loader.hair.follow((hair) => {
      this.hair.show(hair);
      this.viewport.invalidate();
    });
    studio.loader.schedule.follow((schedule) => player.setSchedule(schedule));
    preview.preview.follow((made) => {
      this.ghost.show(made?.meshes ?? []);
      this.viewport.invalidate();
    });
    for (const signal of [studio.isOnion, studio.compares]) signal.changed(() => this.viewport.invalidate());
    let color = "";
    studio.history.current.follow((document) => {
      if (document.color !== color) this.setColor((color = document.color));
    });
    language.changed(() => this.viewport.canvas.setAttribute("aria-label", words().picture));
  }

  tuftAt(ray: Ray): number | null {
    const id = this.hair.tuftAt(ray);
    return id === 0 ? null : id;
  }

  /** Another head to draw on. */
  setHead(painted: PaintedHead): void {
    this.viewport.stage.scene.remove(this.painted.group);
    this.painted.dispose();
    this.painted = painted;
    this.studio.scalp.value = painted.scalp;
    this.viewport.stage.scene.add(painted.group);
    this.head.value = new HeadSurface(painted.surface);
    this.setColor(this.studio.document.color);
    this.viewport.invalidate();
  }

  /** The head of the document comes into the picture. @param view  from where */
  frameHead(view: View = "quarter"): void {
    const { head } = this.studio.document;
    const scale = headScale(head);
    const middle = new Vector3(...(head.center ?? [0, 0, 0]));
    this.viewport.stage.lightUp(middle.toArray(), kLit * scale);
    this.viewport.home = { middle: middle.add(new Vector3(0, kMiddle * scale, 0)), height: kHeight * scale };
    this.viewport.look(view);
  }

  /** What is drawn of the head. */
  get headGroup(): Group {
    return this.painted.group;
  }

  private setColor(color: string): void {
    this.hair.setColor(color);
    this.ghost.setColor(color);
    this.painted.setScalpTones(hairTones(color).tones);
    this.viewport.invalidate();
  }

  private get moves(): boolean {
    return this.studio.mode.value === "move";
  }

  private get compares(): boolean {
    return this.moves && this.studio.compares.value && this.studio.loader.hair.value.smooth !== null;
  }

  /** Playback goes on. @return  whether there is something new to see */
  private tick(): boolean {
    if (!this.moves) return false;
    const changed = this.player.tick();
    this.frame.value = this.player.frame;
    this.picture.value = this.player.picture;
    return changed || (this.compares && this.player.playing);
  }

  private paint(): void {
    const { stage, camera, size, overlay } = this.viewport;
    overlay.element.style.visibility = this.compares ? "hidden" : "visible";
    if (!this.compares) {
      this.hair.showPicture(this.moves ? this.player.picture : null, this.studio.isOnion.value);
      stage.render(camera);
      return;
    }
    const half = { y: 0, width: size.width / 2, height: size.height };
    this.hair.showPicture(this.player.picture, this.studio.isOnion.value);
    stage.render(camera, { x: 0, ...half });
    this.hair.showSmooth(this.player.phase01);
    stage.render(camera, { x: half.width, ...half });
  }
}
