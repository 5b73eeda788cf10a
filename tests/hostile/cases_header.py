"""Header sections that must be refused."""

from __future__ import annotations

from cases import Case, get, head

END = "RFC 9112 2.2: a line ends with CR LF"
FOLD = "RFC 9112 5.2: a folded line"
COLON = "RFC 9112 5.1: no space between name and colon"
NAME = "RFC 9110 5.1, 5.6.2: a name is a token"
VALUE = "RFC 9110 5.5: a control character in a value"
HOST_ONCE = "RFC 9112 3.2: exactly one Host"
HOST_VALUE = "RFC 9112 3.2, RFC 3986 3.2.2: no host"
MANY = "RFC 6585 5, our limit is 64 headers"
BIG = "RFC 6585 5, our limit is 16 KiB of head"
START = b"GET /v1/version HTTP/1.1\r\nHost: localhost\r\n"
FIRST = "GET /v1/version HTTP/1.1"


def host(*lines: str, version: str = "1.1") -> bytes:
    return head(f"GET /v1/version HTTP/{version}", *lines)


_NAMES = {"a space": "Na me", "a bracket": "Na(me", "a slash": "Na/me", "a quote": 'Na"me', "a square bracket": "Na[me", "a brace": "Na{me", "an at sign": "Na@me",
          "a comma": "Na,me", "a semicolon": "Na;me", "an equals sign": "Na=me", "a question mark": "Na?me", "an angle bracket": "Na<me", "a backslash": "Na\\me",
          "DEL": "Na\x7fme", "a control character": "Na\x01me", "UTF-8": "Na\xc3\xa4me", "a tab": "Na\tme", "NUL": "Na\0me"}
_VALUES = {"NUL": "\0", "SOH": "\x01", "backspace": "\x08", "vertical tab": "\x0b", "form feed": "\x0c", "ESC": "\x1b", "US": "\x1f", "DEL": "\x7f"}

CASES = [
    Case("a bare LF after a header", START + b"X: y\nZ: w\r\n\r\n", 400, END),
    Case("a bare LF that hides a header", START + b"X: y\nContent-Length: 5\r\n\r\n", 400, END),
    Case("bare LFs throughout", b"GET /v1/version HTTP/1.1\nHost: localhost\n\n", 400, END),
    Case("a bare LF for the empty line", START + b"\n", 400, END),
    Case("LF CR", START + b"X: y\n\r\r\n\r\n", 400, END),
    Case("a bare CR in a value", START + b"X: a\rb\r\n\r\n", 400, "RFC 9112 2.2: a bare CR"),
    Case("a bare CR that hides a header", START + b"X: a\rTransfer-Encoding: chunked\r\n\r\n", 400, "RFC 9112 2.2: a bare CR"),
    Case("a bare CR in a name", START + b"X\r: a\r\n\r\n", 400, "RFC 9112 2.2: a bare CR"),
    Case("CR CR LF", START + b"X: a\r\r\n\r\n", 400, "RFC 9112 2.2: a bare CR"),
    Case("a line folded by a space", get("X: a", " b"), 400, FOLD),
    Case("a line folded by a tab", get("X: a", "\tb"), 400, FOLD),
    Case("a line folded to nothing", get("X: a", " "), 400, FOLD),
    Case("a folded Host", host("Host:", " localhost"), 400, FOLD),
    Case("a space before the first header", host(" X: a", "Host: localhost"), 400, "RFC 9112 2.2: space between request line and headers"),
    Case("a hidden Host before the first", host(" Host: other", "Host: localhost"), 400, "RFC 9112 2.2"),
    Case("a tab before the first header", host("\tX: a", "Host: localhost"), 400, "RFC 9112 2.2"),
    Case("a space before a colon", get("X : a"), 400, COLON),
    Case("a tab before a colon", get("X\t: a"), 400, COLON),
    Case("a space before Host's colon", host("Host : localhost"), 400, COLON),
    Case("no name", get(": a"), 400, NAME),
    Case("a space for a name", get(" : a"), 400, FOLD),
    Case("no colon", get("Hello"), 400, "RFC 9112 5: name, colon, value"),
    Case("a request line among headers", get("GET /v1/limits HTTP/1.1"), 400, NAME),
    *(Case(f"{what} in a name", get(name + ": a"), 400, NAME) for what, name in _NAMES.items()),
    *(Case(f"{what} in a value", get(f"X: a{byte}b"), 400, VALUE) for what, byte in _VALUES.items()),
    Case("NUL at a value's end", get("X: a\0"), 400, VALUE),
    Case("65 headers", get(*(f"X-{i}: a" for i in range(64))), 431, MANY),
    Case("1,000 headers", get(*(f"X: {i}" for i in range(1_000))), 431, MANY),
    Case("5,000 empty headers", get(*("X:" for _ in range(5_000))), 431, MANY),
    Case("a value of 17 KiB", get("X: " + "a" * 17 * 1024), 431, BIG),
    Case("a name of 17 KiB", get("a" * 17 * 1024 + ": a"), 431, BIG),
    Case("20 headers of 1 KiB", get(*(f"X-{i}: " + "a" * 1024 for i in range(20))), 431, BIG),
    Case("a value that never ends", START + b"X: " + b"a" * 20 * 1024, 431, BIG, is_whole=False),
    Case("headers that never end", START + b"X: a\r\n" * 2_000, 431, MANY, is_whole=False),
    Case("a name that never ends", START + b"a" * 20 * 1024, 431, BIG, is_whole=False),
    Case("no Host", host(), 400, HOST_ONCE),
    Case("no Host but others", host("X: a", "Accept: */*"), 400, HOST_ONCE),
    Case("Host twice", host("Host: localhost", "Host: localhost"), 400, HOST_ONCE),
    Case("two Hosts", host("Host: localhost", "Host: other"), 400, HOST_ONCE),
    Case("two Hosts of different case", host("Host: localhost", "hOST: other"), 400, HOST_ONCE),
    Case("two Hosts in 1.0", host("Host: localhost", "Host: other", version="1.0"), 400, HOST_ONCE),
    Case("a Host of two words", host("Host: local host"), 400, HOST_VALUE),
    Case("a Host with a path", host("Host: localhost/v1"), 400, HOST_VALUE),
    Case("a Host that is a URL", host("Host: http://localhost"), 400, HOST_VALUE),
    Case("a Host with a user", host("Host: user@localhost"), 400, HOST_VALUE),
    Case("a list of Hosts", host("Host: localhost,other"), 400, HOST_VALUE),
    Case("a list of Hosts with a space", host("Host: localhost, other"), 400, HOST_VALUE),
    Case("a Host with NUL", host("Host: local\0host"), 400, VALUE),
    Case("Expect of something else", head("POST /v1/schedules HTTP/1.1", "Host: localhost", "Content-Length: 5", "Expect: 200-ok"), 417, "RFC 9110 10.1.1", is_whole=False),
    Case("Expect of a list", head("POST /v1/schedules HTTP/1.1", "Host: localhost", "Content-Length: 5", "Expect: 100-continue, fast"), 417, "RFC 9110 10.1.1", is_whole=False),
    Case("Expect of something else, GET", get("Expect: tea"), 417, "RFC 9110 10.1.1"),
]
