import { History } from "../../../client-examples/studio/src/model/History";

describe("History", () => {
  it("goes back to the first value and forward to the last, step by step", () => {
    const history = new History("a");
    for (const value of ["b", "c", "d"]) history.change(value);
    const back = [];
    while (history.canUndo) {
      history.undo();
      back.push(history.value);
    }
    expect(back).toEqual(["c", "b", "a"]);
    const forward = [];
    while (history.canRedo) {
      history.redo();
      forward.push(history.value);
    }
    expect(forward).toEqual(["b", "c", "d"]);
  });

  it("makes one step of changes with the same merge", () => {
    const history = new History(0);
    for (const value of [1, 2, 3]) history.change(value, "slider");
    history.undo();
    expect(history.value).toBe(0);
  });

  it("makes two steps where a merge was settled, or another came between", () => {
    const history = new History(0);
    history.change(1, "slider");
    history.settle();
    history.change(2, "slider");
    history.change(3, "other");
    history.change(4, "slider");
    const values = [];
    while (history.canUndo) {
      history.undo();
      values.push(history.value);
    }
    expect(values).toEqual([3, 2, 1, 0]);
  });

  it("does not merge into what was undone", () => {
    const history = new History(0);
    history.change(1, "slider");
    history.undo();
    history.change(2, "slider");
    history.undo();
    expect(history.value).toBe(0);
  });

  it("forgets the future when something else is done", () => {
    const history = new History(0);
    history.change(1);
    history.undo();
    history.change(2);
    expect(history.canRedo).toBe(false);
    expect(history.value).toBe(2);
  });

  it("makes no step of the same value", () => {
    const history = new History(0);
    history.change(0);
    expect(history.canUndo).toBe(false);
  });

  it("keeps 200 steps", () => {
    const history = new History(0);
    for (let value = 1; value <= 300; value++) history.change(value);
    while (history.canUndo) history.undo();
    expect(history.value).toBe(100);
  });

  it("tells of every change, undo and redo, and of nothing else", () => {
    const history = new History("a");
    const seen: string[] = [];
    history.current.changed((value) => seen.push(value));
    history.change("b");
    history.undo();
    history.undo();
    history.redo();
    expect(seen).toEqual(["b", "a", "b"]);
  });
});
