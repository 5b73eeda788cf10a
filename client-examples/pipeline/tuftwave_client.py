"""Posts a hairstyle to a Tuftwave service and writes its answers as files.

    python3 client-examples/pipeline/tuftwave_client.py vita.json --out vita.glb --sheet vita.xdts --csv vita.csv --json vita_report.json

The service is --server, else the environment variable TUFTWAVE_URL, else http://127.0.0.1:8080. Proxy variables are ignored.
A busy service (503, 429) is asked again. Files appear whole or not at all, and only after every answer has arrived.
Exit code: 0 written; 1 the service refused, or a file could not be read or written; 2 there is no Tuftwave to talk to.
"""

from __future__ import annotations

import argparse
import http.client
import json
import os
import sys
import time
import urllib.error
import urllib.request
from dataclasses import dataclass
from typing import Any, Callable, Optional

DEFAULT_SERVER = "http://127.0.0.1:8080"
OUTPUTS = [  # option, media type, help
    ("out", "model/gltf-binary", "the hair, .glb"),
    ("sheet", "application/x-xdts+json", "the exposure sheet, .xdts (needs a motion)"),
    ("csv", "text/csv", "the exposure sheet, .csv (needs a motion)"),
    ("json", "application/json", "report, schedule and poses, .json"),
]
BUSY = (429, 503)
LONGEST_WAIT_S = 60.0  # a service that asks for more is given up on


@dataclass
class Patience:
    retries: int = 5  # how often a busy service is asked again
    timeout_s: float = 60  # without a byte
    reconnects: int = 0  # how often a service that drops or refuses the connection is tried again
    wait: Callable[[float], Any] = time.sleep
    say: Callable[[str], Any] = lambda text: print(text, file=sys.stderr)


@dataclass
class Answer:
    data: bytes
    frame_rate: Optional[str]  # frames per second, which an XDTS or CSV does not store


class Refused(Exception):
    """The service answered, but not with the hair; the text is for people."""


class Busy(Refused):
    """The service has no time, even after all retries; later it may."""


class NoService(Exception):
    """Nobody answered, or somebody who is not a Tuftwave service."""


class NoRedirects(urllib.request.HTTPRedirectHandler):
    """A redirected POST would quietly become a GET."""

    def redirect_request(self, *_: Any) -> None:
        return None


def problem_text(status: int, body: bytes) -> str:
    """An RFC 9457 problem as lines to read."""
    try:
        problem: Any = json.loads(body)
    except (ValueError, RecursionError):
        problem = None
    if not isinstance(problem, dict) or "title" not in problem:
        return f"{status}: {body[:200].decode('utf-8', 'replace').strip() or 'no text'}"
    request_id = f" (request {problem['request_id']})" if problem.get("request_id") else ""
    lines = [f"{status} {problem['title']}: {problem.get('detail', '')}{request_id}"]
    errors = problem.get("errors")
    for error in errors if isinstance(errors, list) else []:
        if isinstance(error, dict):
            line = f"  {error.get('pointer') or '/'}: {error.get('detail', error.get('code', ''))}"
            facts = [f"given {json.dumps(error['value'])}"] if "value" in error else []
            facts += [f"allowed {error['allowed']}"] if "allowed" in error else []
            lines.append(line + (f" ({', '.join(facts)})" if facts else ""))
    return "\n".join(lines)


def read_body(error: urllib.error.HTTPError) -> bytes:
    try:
        with error:
            return error.read()
    except (OSError, http.client.HTTPException):  # the status alone still says something
        return b""


def seconds_to_wait(retry_after: Optional[str], attempt: int) -> float:
    """What the service asks for, else half a second, doubled each time up to 8 s."""
    if retry_after and retry_after.strip().isdecimal():
        return float(retry_after.strip())
    return min(8.0, 0.5 * 2 ** attempt)


def open_request(server: str, path: str, body: bytes, content_type: str, media_type: str, timeout_s: float) -> Answer:
    """One request and its answer; raises what urllib raises, and NoService."""
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}), NoRedirects())
    request = urllib.request.Request(server.rstrip("/") + path, data=body, method="POST", headers={
        "Content-Type": content_type, "Accept": media_type, "User-Agent": "tuftwave-client"})
    with opener.open(request, timeout=timeout_s) as response:
        answered = response.headers.get_content_type()
        if answered != media_type:
            raise NoService(f"{server} answered with {answered} instead of {media_type}; is it a Tuftwave service?")
        return Answer(response.read(), response.headers.get("Tuftwave-Frame-Rate"))


def wait_if_busy(error: urllib.error.HTTPError, attempt: int, patience: Patience) -> None:
    """Waits as long as the service asks for. Raises Refused where it said something else, Busy where it is time to give up."""
    text = problem_text(error.code, read_body(error))
    if error.code not in BUSY:
        raise Refused(text) from None
    if attempt == patience.retries:
        raise Busy(text) from None
    wait_s = seconds_to_wait(error.headers.get("Retry-After"), attempt)
    if wait_s > LONGEST_WAIT_S:
        raise Busy(f"{text}\nThe service asks to come back in {wait_s:.0f} s.") from None
    patience.say(f"busy ({error.code}), asking again in {wait_s:g} s")
    patience.wait(wait_s)


def post(server: str, path: str, body: bytes, media_type: str, patience: Patience, content_type: str = "application/json") -> Answer:
    """One answer of a POST, asked for as often as patience allows; the same bytes give the same answer, so that is safe.

    Raises Refused, Busy or NoService.
    """
    attempt = reconnects = 0
    while True:
        try:
            return open_request(server, path, body, content_type, media_type, patience.timeout_s)
        except urllib.error.HTTPError as error:
            wait_if_busy(error, attempt, patience)
            attempt += 1
        except (OSError, http.client.HTTPException, UnicodeError) as error:
            reason = getattr(error, "reason", None) or error
            text = f"No answer from {server}: {str(reason) or type(reason).__name__}."
            if not isinstance(reason, ConnectionError) or reconnects == patience.reconnects:
                raise NoService(f"{text} Is the service running there?") from None
            wait_s = seconds_to_wait(None, reconnects)
            patience.say(f"{text} Trying again in {wait_s:g} s")
            patience.wait(wait_s)
            reconnects += 1


def write_whole(path: str, data: bytes) -> None:
    """Writes a file so that nobody ever sees half of it."""
    folder, name = os.path.split(os.path.abspath(path))
    part = os.path.join(folder, f".{name}.{os.getpid()}.part")
    try:
        with open(part, "xb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(part, path)
    except BaseException:
        if os.path.exists(part):
            os.remove(part)
        raise


def parse_arguments(arguments: Optional[list[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Posts a hairstyle to Tuftwave and writes its answers.")
    parser.add_argument("hairstyle", help='the JSON body; "-" is the standard input')
    for option, _, text in OUTPUTS:
        parser.add_argument(f"--{option}", metavar="FILE", help=text)
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_URL") or DEFAULT_SERVER, help="address (%(default)s)")
    parser.add_argument("--retries", type=int, default=5, help="how often a busy service is asked again (%(default)s)")
    parser.add_argument("--timeout", type=float, default=60, help="seconds without a byte before giving up (%(default)s)")
    options = parser.parse_args(arguments)
    if not any(getattr(options, option) for option, _, _ in OUTPUTS):
        parser.error("name at least one file: " + ", ".join(f"--{option}" for option, _, _ in OUTPUTS))
    if not options.server.startswith(("http://", "https://")):
        parser.error(f"--server must begin with http:// or https://, not {options.server!r}")
    if options.retries < 0 or not options.timeout > 0:
        parser.error("--retries must be at least 0 and --timeout above 0")
    return options


def main(arguments: Optional[list[str]] = None) -> int:
    options = parse_arguments(arguments)
    try:
        if options.hairstyle == "-":
            body = sys.stdin.buffer.read()
        else:
            with open(options.hairstyle, "rb") as file:
                body = file.read()
        wanted = [(getattr(options, option), media_type) for option, media_type, _ in OUTPUTS if getattr(options, option)]
        patience = Patience(options.retries, options.timeout)
        answers = [(path, post(options.server, "/v1/hairstyles", body, media_type, patience)) for path, media_type in wanted]
        for path, answer in answers:
            write_whole(path, answer.data)
            rate = f", {answer.frame_rate} frames per second" if answer.frame_rate else ""
            print(f"{path}: {len(answer.data)} bytes{rate}")
    except (Refused, OSError) as error:
        print(f"tuftwave_client: {error}", file=sys.stderr)
        return 1
    except NoService as error:
        print(f"tuftwave_client: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
