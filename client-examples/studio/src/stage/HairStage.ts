import { Vector3, type Group, type Ray } from "three";
import type { Vec3 } from "../api/contract";
import { Signal } from "../base/Signal";
import type { FillPreview } from "../fill/FillPreview";
import { HairView } from "../hair/HairView";
import type { Player } from "../motion/Player";
import { hairTones } from "../paint/hairTones";
import type { HeadBall } from "../model/HeadBall";
import type { PaintedHead } from "../paint/PaintedHead";
import type { Mode, Studio } from "../Studio";
import { language } from "../text/language";
import { stageText } from "../text/stageText";
import { DrawTool } from "./DrawTool";
import { FillTool } from "./FillTool";
import { GhostView } from "./GhostView";
import type { Guest } from "./Guest";
import { HeadSurface } from "./HeadSurface";
import type { Scene } from "./Scene";
import { ShapeTool } from "./ShapeTool";
import type { Tool } from "./Tool";
import { Viewport } from "./Viewport";
import { WindTool } from "./WindTool";

const kBundled: HeadBall = { center: [0, 0, 0], radius: 0.1 };
const kFront: Vec3 = [0, 0, 1];
// Of the head's radius.
const kShown = 4.6; // height of the scene
const kBelow = 0.2; // the middle of the picture under the head's

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
  private guest: Guest | null = null;
  private headBall = kBundled;
  private front = kFront;
  private lookedAt: Guest | PaintedHead;

  constructor(private readonly studio: Studio, preview: FillPreview, private readonly player: Player, private painted: PaintedHead) {
    const words = () => stageText[language.value];
    this.lookedAt = painted;
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
    this.viewport.columns = () => (this.compares ? 2 : 1);
    studio.mode.follow((mode) => {
      this.showSubject();
      this.viewport.use(this.tools[mode]);
    });
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

  /** Another head to draw on; it is this stage's from now on. @param ball  where it is, if it is not the bundled one; @param front  where it looks */
  setHead(painted: PaintedHead, ball: HeadBall = kBundled, front: Vec3 = kFront): void {
    this.viewport.stage.scene.remove(this.painted.group);
    this.painted.dispose();
    this.painted = painted;
    this.headBall = ball;
    this.hair.setHead(ball);
    this.ghost.setHead(ball);
    this.front = front;
    this.studio.scalp.value = painted.scalp;
    this.viewport.stage.scene.add(painted.group);
    this.head.value = new HeadSurface(painted.surface);
    this.setColor(this.studio.document.color);
    this.showSubject();
    this.viewport.use(this.tools[this.studio.mode.value]); // what it shows is as large as the head
  }

  /** A character that is shown while things move; null is none. It stays with those who made it. */
  setGuest(guest: Guest | null): void {
    if (this.guest) this.viewport.stage.scene.remove(this.guest.group);
    this.guest = guest;
    if (guest) this.viewport.stage.scene.add(guest.group);
    this.showSubject();
    if (this.moves) this.viewport.use(this.tools.move);
  }

  get ball(): HeadBall {
    return this.shownGuest?.ball ?? this.headBall;
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

  private get shownGuest(): Guest | null {
    return this.moves ? this.guest : null;
  }

  /** Shows the character or the head with its hair, and looks at it if something else was looked at before. */
  private showSubject(): void {
    const { shownGuest: guest, painted } = this;
    if (this.guest) this.guest.group.visible = guest !== null;
    for (const { group } of [painted, this.hair, this.ghost]) group.visible = guest === null;
    this.viewport.invalidate();
    if (this.lookedAt === (guest ?? painted)) return;
    this.lookedAt = guest ?? painted;
    const { center, radius } = this.ball;
    const middle = guest?.middle ?? new Vector3(center[0], center[1] - kBelow * radius, center[2]);
    this.viewport.setSubject(middle, guest?.height ?? kShown * radius, guest?.front ?? this.front, guest ? "front" : "quarter");
    this.viewport.stage.lightUp([middle.x, middle.y, middle.z], guest ? guest.height / 2 : 3 * radius);
  }

  private get moves(): boolean {
    return this.studio.mode.value === "move";
  }

  private get compares(): boolean {
    return this.moves && this.studio.compares.value && (this.shownGuest !== null || this.studio.loader.hair.value.smooth !== null);
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
      this.shownGuest?.showPicture(this.player.picture);
      stage.render(camera);
      return;
    }
    const half = { y: 0, width: size.width / 2, height: size.height };
    this.hair.showPicture(this.player.picture, this.studio.isOnion.value);
    this.shownGuest?.showPicture(this.player.picture);
    stage.render(camera, { x: 0, ...half });
    this.hair.showSmooth(this.player.phase01);
    this.shownGuest?.showSmooth(this.player.phase01);
    stage.render(camera, { x: half.width, ...half });
  }
}
