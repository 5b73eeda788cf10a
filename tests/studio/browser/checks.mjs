import { answersAtOnce } from "./checks/answersAtOnce.mjs";
import { asksForKey } from "./checks/asksForKey.mjs";
import { capturesCycle } from "./checks/capturesCycle.mjs";
import { drawsFreehand } from "./checks/drawsFreehand.mjs";
import { drawsPointByPoint } from "./checks/drawsPointByPoint.mjs";
import { fillsGap } from "./checks/fillsGap.mjs";
import { fitsAndSpeaks } from "./checks/fitsAndSpeaks.mjs";
import { goesOnAlone } from "./checks/goesOnAlone.mjs";
import { isAccessible } from "./checks/isAccessible.mjs";
import { keepsItself } from "./checks/keepsItself.mjs";
import { managesTufts } from "./checks/managesTufts.mjs";
import { opensFiles } from "./checks/opensFiles.mjs";
import { opensGallery } from "./checks/opensGallery.mjs";
import { plays } from "./checks/plays.mjs";
import { shapesPoints } from "./checks/shapesPoints.mjs";
import { showsProblem } from "./checks/showsProblem.mjs";
import { takesAway } from "./checks/takesAway.mjs";
import { undoesEverything } from "./checks/undoesEverything.mjs";
import { worksByKeys } from "./checks/worksByKeys.mjs";

/** All checks, in the order in which they run. */
export const checks = [
  drawsFreehand, drawsPointByPoint, shapesPoints, managesTufts, undoesEverything, fillsGap, capturesCycle, plays, keepsItself, takesAway, opensFiles,
  opensGallery, showsProblem, goesOnAlone, asksForKey, worksByKeys, isAccessible, fitsAndSpeaks, answersAtOnce,
];
