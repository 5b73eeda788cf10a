// Names for the contract's types, which are generated.
import type { components } from "./generated/openapi";

type Schemas = components["schemas"];

export type Vec3 = Schemas["Vec3"];
export type Rotation = Schemas["Rotation"];
export type Head = Schemas["Head"];
export type ScalpMesh = Schemas["ScalpMesh"];
export type Tuft = Schemas["Tuft"];
export type Fill = Schemas["Fill"];
export type Motion = Schemas["Motion"];
export type Wave = Schemas["Wave"];
export type Timing = Schemas["Timing"];
export type Phasing = Schemas["Phasing"];
export type Hairstyle = Schemas["HairstyleRequest"];
export type HairstyleAnswer = Schemas["HairstyleAnswer"];
export type FillsAnswer = Schemas["FillsAnswer"];
export type Schedule = Schemas["Schedule"];
export type ScheduleAnswer = Schemas["ScheduleAnswer"];
export type Picture = Schemas["Picture"];
export type ChainPose = Schemas["ChainPose"];
export type CharacterChain = Schemas["CharacterChain"];
export type CharacterChainsAnswer = Schemas["CharacterChainsAnswer"];
export type CharacterMotionAnswer = Schemas["CharacterMotionAnswer"];
export type ProblemDocument = Schemas["Problem"];
export type FieldError = Schemas["FieldError"];
