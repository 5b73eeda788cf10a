"""Checks who includes whom, from what the compiler itself wrote down, and how long files are.

    python3 tests/architecture/check_layers.py --build build/release
    python3 tests/architecture/check_layers.py --self-test

Link visibility does not keep layers apart, because system headers are visible to all. The build directory must be one of
Ninja's, and complete. Exit code 0 if everything holds, else 1. --self-test feeds made-up dependencies to every rule and
wants to see each one broken.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
from typing import Optional

sys.dont_write_bytecode = True
ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))

# main -> http -> service -> access -> api -> (gltf, poses, sheets) -> core, with config, exec and log beside service.
# For each layer those it may include, by whatever way.
MAY_INCLUDE = {
    "core": set(),
    "version": set(),
    "memory": set(),
    "assets": set(),
    "log": {"core", "api"},
    "exec": {"core"},
    "config": {"core"},
    "sheets": {"core"},
    "poses": {"core", "assets"},
    "gltf": {"core", "version", "memory"},
    "character": {"core", "gltf"},
    "api": {"core", "gltf", "poses", "sheets", "character", "assets", "version", "memory"},
    "access": {"core", "gltf", "poses", "sheets", "character", "assets", "version", "memory", "api", "config"},
    "service": {"core", "gltf", "poses", "sheets", "character", "assets", "version", "memory", "api", "config", "exec", "log", "access"},
    "http": {"core", "gltf", "poses", "sheets", "character", "assets", "version", "memory", "api", "config", "exec", "log", "access", "service"},
    "main": {"core", "gltf", "poses", "sheets", "character", "assets", "version", "memory", "api", "config", "exec", "log", "access", "service", "http"},
}
# Libraries by a pattern of their headers, and the layer whose one .cpp may include them.
ONE_USER = {"httplib": (r"/httplib\.h$", "http"), "spdlog": (r"/spdlog/", "log")}
# The same by our own include lines, where other libraries' headers bring it along: httplib's includes OpenSSL.
ONE_ASKER = {"OpenSSL": (r"^\s*#\s*include\s*<openssl/", "access")}
# What the standard library of g++ or clang is made of, libc included.
STANDARD = re.compile(
    r"^(/usr/include/c\+\+/|/usr/lib/gcc/|/usr/lib/llvm-\d+/(lib/clang|include/c\+\+)/|/usr/lib/clang/"
    r"|/usr/include/[a-z0-9_]+-linux-gnu/(c\+\+|bits|sys|gnu|asm)/|/usr/include/(linux|asm-generic|bits|sys|gnu|asm)/"
    r"|/usr/include/(alloca|assert|ctype|endian|errno|features|features-time64|fenv|inttypes|libintl|limits|locale|math|pthread|sched|semaphore|signal"
    r"|stdc-predef|stdint|stdio|stdlib|string|strings|syscall|time|unistd|wchar|wctype)\.h$)")
# Core does no I/O, keeps no time, owns no thread and knows no chance: what its files may not ask for themselves.
NOT_FOR_CORE = {"atomic", "cassert", "chrono", "condition_variable", "cstdio", "cstdlib", "ctime", "filesystem", "fstream", "future", "iomanip", "ios",
                "iostream", "istream", "locale", "mutex", "ostream", "random", "regex", "semaphore", "shared_mutex", "sstream", "stdexcept", "thread"}
MOST_LINES = {".cpp": 400, ".hpp": 150}

Units = dict[str, list[str]]  # a source file, and all that it includes


def layer_of(path: str) -> Optional[str]:
    """The layer of one of our files, None for anybody else's."""
    if re.search(r"(^|/)generated/version\.hpp$", path):
        return "version"
    relative = os.path.relpath(path, ROOT)
    parts = relative.split(os.sep)
    if parts[0] == "core":
        return "core"
    if parts[0] == "server":
        return "main" if parts[1] == "main.cpp" else parts[1]
    return None


def short(path: str) -> str:
    return os.path.relpath(path, ROOT) if path.startswith(ROOT + os.sep) else path


def read_units(build: str) -> Units:
    """Every translation unit that Ninja has built, with its dependencies. Raises RuntimeError."""
    done = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"ninja -t deps: {done.stderr.strip() or done.stdout.strip()}")
    units: Units = {}
    for block in done.stdout.split("\n\n"):
        files = [os.path.normpath(os.path.join(build, line.strip())) for line in block.split("\n")[1:] if line.startswith("    ")]
        sources = [path for path in files if path.endswith(".cpp")]
        if sources:
            units[sources[0]] = [path for path in files if path != sources[0]]
    return units


def our_files(folders: list[str], ending: str) -> list[str]:
    return sorted(os.path.join(at, name) for folder in folders for at, below, names in os.walk(os.path.join(ROOT, folder))
                  if "node_modules" not in at for name in names if name.endswith(ending))


def check_direction(units: Units) -> list[str]:
    """Nothing includes a layer to its left."""
    wrong = []
    for source, included in units.items():
        layer = layer_of(source)
        if layer is None:
            continue
        if layer not in MAY_INCLUDE:
            wrong.append(f"{short(source)}: {layer} is no layer; give it a line in MAY_INCLUDE")
            continue
        for path in included:
            other = layer_of(path)
            if other not in (None, layer) and other not in MAY_INCLUDE[layer]:
                wrong.append(f"{short(source)}: {layer} must not include {short(path)}")
    return wrong


def check_core(units: Units) -> list[str]:
    """Core knows itself and the standard library."""
    return [f"{short(source)}: core must not include {path}" for source, included in units.items() if layer_of(source) == "core"
            for path in included if layer_of(path) is None and not STANDARD.match(path)]


def check_core_words(texts: dict[str, str]) -> list[str]:
    """Core's own include lines ask for nothing that does I/O or keeps time."""
    return [f"{short(path)}: core must not ask for <{header}>" for path, text in texts.items()
            for header in re.findall(r"^\s*#\s*include\s*<([^>]+)>", text, re.MULTILINE) if header in NOT_FOR_CORE or "/" in header or header.endswith(".h")]


def check_one_user(units: Units) -> list[str]:
    """Each library behind one .cpp."""
    wrong = []
    for library, (pattern, layer) in ONE_USER.items():
        users = [source for source, included in units.items() if layer_of(source) and any(re.search(pattern, path) for path in included)]
        if len(users) != 1 or layer_of(users[0]) != layer:
            wrong.append(f"{library} must have exactly one user, in {layer}; it has {', '.join(map(short, users)) or 'none'}")
    return wrong


def check_one_asker(texts: dict[str, str]) -> list[str]:
    """Libraries that come along elsewhere are asked for by one .cpp."""
    wrong = []
    for library, (pattern, layer) in ONE_ASKER.items():
        askers = [path for path, text in texts.items() if re.search(pattern, text, re.MULTILINE)]
        if len(askers) != 1 or layer_of(askers[0]) != layer or not askers[0].endswith(".cpp"):
            wrong.append(f"{library} must be asked for by exactly one .cpp, in {layer}; it is by {', '.join(map(short, askers)) or 'none'}")
    return wrong


def check_complete(units: Units, sources: list[str]) -> list[str]:
    """The build knows every source file, or the other checks have looked past some."""
    return [f"{short(source)}: the build directory knows nothing of it; build everything first" for source in sources if source not in units]


def check_lengths(lengths: dict[str, int]) -> list[str]:
    return [f"{short(path)}: {lines} lines, at most {MOST_LINES[os.path.splitext(path)[1]]}" for path, lines in lengths.items()
            if lines > MOST_LINES[os.path.splitext(path)[1]]]


def text_of(path: str) -> str:
    with open(path, encoding="utf-8") as file:
        return file.read()


def report(results: list[tuple[str, list[str]]]) -> int:
    for name, wrong in results:
        for line in wrong:
            print(f"FAILED {name}: {line}")
    failed = sum(bool(wrong) for _, wrong in results)
    print(f"{len(results) - failed} passed, {failed} failed")
    return 1 if failed else 0


def check(build: str) -> int:
    units = read_units(build)
    core_files = our_files(["core"], ".cpp") + our_files(["core"], ".hpp")
    files = our_files(["core", "server"], ".cpp") + our_files(["core", "server"], ".hpp")
    return report([
        ("every source is built", check_complete(units, our_files(["core", "server"], ".cpp"))),
        ("direction", check_direction(units)),
        ("core is alone", check_core(units)),
        ("core has no I/O", check_core_words({path: text_of(path) for path in core_files})),
        ("one user per library", check_one_user(units)),
        ("one asker per library", check_one_asker({path: text_of(path) for path in files})),
        ("lengths", check_lengths({path: text_of(path).count("\n") for path in files})),
        *self_tests(),
    ])


def self_tests() -> list[tuple[str, list[str]]]:
    """Made-up dependencies: what is allowed passes, what is forbidden is found."""
    def ours(path: str) -> str:
        return os.path.join(ROOT, path)

    good = {
        ours("core/src/wave.cpp"): [ours("core/include/tuftwave/wave.hpp"), "/usr/include/c++/12/cmath", "/usr/include/math.h"],
        ours("server/gltf/document.cpp"): [ours("server/gltf/document.hpp"), "/usr/include/tiny_gltf.h", ours("core/include/tuftwave/math.hpp")],
        ours("server/api/hair.cpp"): [ours("server/gltf/hair_file.hpp"), ours("build/x/server/generated/version.hpp"), "/usr/include/nlohmann/json.hpp"],
        ours("server/poses/vmd.cpp"): [ours("server/assets/assets.hpp"), ours("core/include/tuftwave/motion.hpp")],
        ours("server/http/listener.cpp"): [ours("server/service/service.hpp"), "/usr/include/httplib.h"],
        ours("server/log/log.cpp"): ["/usr/include/spdlog/async.h"],
        ours("server/access/access.cpp"): [ours("server/api/routes.hpp"), ours("server/config/config.hpp")],
        ours("server/service/service.cpp"): [ours("server/access/access.hpp")],
        ours("tests/core/wave_test.cpp"): ["/usr/include/gtest/gtest.h", ours("server/http/listener.hpp")],
    }
    bad = [
        ("core includes the server", check_direction, "core/src/wave.cpp", ours("server/api/problem.hpp")),
        ("core includes JSON", check_core, "core/src/wave.cpp", "/usr/include/nlohmann/json.hpp"),
        ("core includes a header like libc's", check_core, "core/src/wave.cpp", "/usr/include/httplib.h"),
        ("gltf includes api", check_direction, "server/gltf/document.cpp", ours("server/api/problem.hpp")),
        ("poses include gltf", check_direction, "server/poses/vmd.cpp", ours("server/gltf/names.hpp")),
        ("gltf includes sheets", check_direction, "server/gltf/document.cpp", ours("server/sheets/csv.hpp")),
        ("api includes service", check_direction, "server/api/hair.cpp", ours("server/service/service.hpp")),
        ("api includes exec", check_direction, "server/api/hair.cpp", ours("server/exec/pool.hpp")),
        ("log includes http", check_direction, "server/log/log.cpp", ours("server/http/listener.hpp")),
        ("access includes service", check_direction, "server/access/access.cpp", ours("server/service/service.hpp")),
        ("api includes access", check_direction, "server/api/hair.cpp", ours("server/access/keys.hpp")),
        ("a layer nobody knows", check_direction, "server/studio/studio.cpp", "/usr/include/c++/12/string"),
        ("httplib twice", check_one_user, "server/api/hair.cpp", "/usr/include/httplib.h"),
        ("httplib in the wrong layer", check_one_user, "server/service/service.cpp", "/usr/include/httplib.h"),
        ("spdlog twice", check_one_user, "server/service/service.cpp", "/usr/include/spdlog/spdlog.h"),
    ]
    results = [(f"self-test: {rule.__name__} allows what is right", rule(good)) for rule in (check_direction, check_core, check_one_user)]
    for name, rule, source, included in bad:
        broken = {**good, ours(source): [*good.get(ours(source), []), included]}
        results.append((f"self-test: {name}", [] if rule(broken) else ["was not found"]))
    others = [
        ("a source that is not built", check_complete(good, [ours("core/src/new.cpp")])),
        ("core asks for a clock", check_core_words({ours("core/src/wave.cpp"): "#include <chrono>\n"})),
        ("core asks for a file", check_core_words({ours("core/src/wave.cpp"): "  # include <fstream>\n"})),
        ("OpenSSL twice", check_one_asker({ours("server/access/digest.cpp"): "#include <openssl/evp.h>\n", ours("server/api/hair.cpp"): "#include <openssl/evp.h>\n"})),
        ("OpenSSL in a header", check_one_asker({ours("server/access/digest.hpp"): "#include <openssl/evp.h>\n"})),
        ("a long source", check_lengths({ours("core/src/wave.cpp"): 401})),
        ("a long header", check_lengths({ours("core/include/tuftwave/wave.hpp"): 151})),
    ]
    return results + [(f"self-test: {name}", [] if wrong else ["was not found"]) for name, wrong in others]


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Checks who includes whom, and how long files are.")
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"), help="a complete build directory of Ninja's (%(default)s)")
    parser.add_argument("--self-test", action="store_true", help="only show that every rule can be broken")
    options = parser.parse_args(arguments)
    if options.self_test:
        return report(self_tests())
    try:
        return check(os.path.abspath(options.build))
    except (RuntimeError, OSError) as error:
        print(f"check_layers: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
