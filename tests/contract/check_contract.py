"""Checks a server against api/openapi.yaml, over the wire.

    python3 tests/contract/check_contract.py --server build/release/server/tuftwave-server
    python3 tests/contract/check_contract.py --server ... --only Limits BadInputs.test_queries

Needs Debian's python3-yaml and python3-jsonschema. Exit code 0 if everything holds, else 1.
"""

from __future__ import annotations

import argparse
import os
import sys
import unittest
import warnings
from typing import Any, Optional

sys.dont_write_bytecode = True
warnings.filterwarnings("ignore", category=DeprecationWarning)  # newer jsonschema would like its resolver replaced
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from service import Service  # noqa: E402
from support import ServiceTest  # noqa: E402


class Counting(unittest.TextTestResult):
    """Counts every row of every table, not only every test."""

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.passed = self.failed = 0

    def addSubTest(self, test: unittest.TestCase, subtest: unittest.TestCase, outcome: Any) -> None:
        super().addSubTest(test, subtest, outcome)
        if outcome is None:
            self.passed += 1
        else:
            self.failed += 1

    def addSuccess(self, test: unittest.TestCase) -> None:
        super().addSuccess(test)
        self.passed += 1

    def addFailure(self, test: unittest.TestCase, error: Any) -> None:
        super().addFailure(test, error)
        self.failed += 1

    def addError(self, test: unittest.TestCase, error: Any) -> None:
        super().addError(test, error)
        self.failed += 1


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Checks a server against its contract.")
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_SERVER"), help="the program (default: the environment's TUFTWAVE_SERVER)")
    parser.add_argument("--only", nargs="+", metavar="Class[.test]", help="run only these")
    options = parser.parse_args(arguments)
    if not options.server or not os.access(options.server, os.X_OK):
        print(f"check_contract: {options.server!r} is no program; build the server and name it with --server", file=sys.stderr)
        return 1
    suite = unittest.defaultTestLoader.discover(os.path.dirname(os.path.abspath(__file__)), pattern="test_*.py")
    if options.only:
        suite = unittest.TestSuite(test for test in flat(suite) if any(f".{only}" in test.id() for only in options.only))
    with Service(options.server) as service:
        ServiceTest.service, ServiceTest.program = service, options.server
        result: Any = unittest.TextTestRunner(sys.stdout, verbosity=1, resultclass=Counting).run(suite)
    print(f"{result.passed} passed, {result.failed} failed")
    return 0 if result.passed and not result.failed and not result.errors else 1


def flat(suite: Any) -> list[unittest.TestCase]:
    return [test for part in suite for test in flat(part)] if isinstance(suite, unittest.TestSuite) else [suite]


if __name__ == "__main__":
    sys.exit(main())
