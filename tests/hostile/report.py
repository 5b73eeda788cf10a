"""Counts what holds, prints what does not, and says what could not be looked at."""

from __future__ import annotations

PASSED, FAILED, SKIPPED = 0, 1, 77  # exit codes; CTest shows the last one as skipped

LONGEST = 1_200  # characters of a reason


class Report:
    """What one run of the suite found."""

    def __init__(self) -> None:
        self.passed = self.failed = self.skipped = 0

    def check(self, what: str, holds: object, why: object = "") -> bool:
        """@param why  what was there in place of what should be; printed only if it does not hold"""
        if holds:
            self.passed += 1
        else:
            self.failed += 1
            print(f"FAILED {what}: {str(why)[:LONGEST]}", flush=True)
        return bool(holds)

    def equal(self, what: str, got: object, wanted: object) -> bool:
        return self.check(what, got == wanted, f"{got!r} in place of {wanted!r}")

    def skip(self, what: str, why: str) -> None:
        self.skipped += 1
        print(f"SKIPPED {what}: {why}", flush=True)

    def note(self, text: str) -> None:
        print(f"  {text}", flush=True)

    @property
    def exit_code(self) -> int:
        if self.failed:
            return FAILED
        return PASSED if self.passed else SKIPPED
