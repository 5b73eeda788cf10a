"""Messages whose end is doubtful, and those that are refused by their head alone."""

from __future__ import annotations

from cases import HOST, INNOCENT, TIMING, Case, chunk, chunked, get, head, post, sized

LENGTH = "RFC 9112 6.3, RFC 9110 8.6: Content-Length is 1*DIGIT, once"
CODING = "RFC 9112 6.1: only `chunked`, once, in 1.1, without a length"
CHUNK = "RFC 9112 7.1: 1 to 16 hexadecimal digits, then CR LF"
PACKED = "RFC 9110 8.4, 15.5.16: nothing is unpacked"
NO_BODY = "RFC 9110 9.3: no body for this method here"
OVER = "RFC 9110 15.5.14: our limit is 16 MiB of JSON, 64 MiB of a file"
HEAD_ONLY = "refused by its head, before its body is there"
N = len(TIMING)
FIVE = chunk(b"{    ")

_LENGTHS = {"with a plus": f"+{N}", "with a minus": f"-{N}", "a list": f"{N},{N}", "a list with a space": f"{N}, {N}", "hexadecimal": f"0x{N:x}", "empty": "", "blank": "  ",
            "two numbers": f"{N} {N}", "with a semicolon": f"{N};", "a fraction": f"{N}.0", "with an exponent": f"{N}e0", "in quotes": f'"{N}"', "a word": "many",
            "with a letter": f"{N}a", "percent-encoded": f"%{ord(str(N)[0]):x}{str(N)[1:]}", "with an underscore": "1_0", "in other digits": "\xd9\xa5", "with a comma": f"{N},",
            "with a vertical tab": f"\x0b{N}", "negative zero": "-0"}
_CODINGS = {"gzip, chunked": "gzip, chunked", "gzip": "gzip", "identity": "identity", "a parameter": "chunked;q=1", "chunked twice": "chunked, chunked", "a comma after": "chunked,",
            "a comma before": ",chunked", "quotes": '"chunked"', "a letter before": "xchunked", "a letter after": "chunkedx", "a space within": "chun ked", "nothing": "",
            "percent-encoding": "%63hunked", "a vertical tab": "\x0bchunked", "chunked, identity": "chunked, identity", "a line break": "\r\n chunked", "NUL": "chunked\0"}
_SIZES = {"letters": "xyz", "nothing": "", "a minus": "-5", "a plus": "+5", "0x": "0x5", "a space before": " 5", "a space after": "5 ", "a tab after": "5\t", "17 digits": "0" * 16 + "5",
          "a fraction": "5.0", "a comma": "5,", "quotes": '"5"', "NUL": "5\0", "an underscore": "0_5", "a space before an extension": "5 ;a=b"}

CASES = [
    *(Case(f"length {what}", post(f"Content-Length: {text}"), 400, LENGTH) for what, text in _LENGTHS.items()),
    Case("the same length twice", post(f"Content-Length: {N}", f"Content-Length: {N}"), 400, LENGTH),
    Case("two lengths", post(f"Content-Length: {N}", f"Content-Length: {N + 1}"), 400, LENGTH),
    Case("two lengths, the first none", post("Content-Length: 0", f"Content-Length: {N}"), 400, LENGTH),
    Case("a length with a space before its colon", post(f"Content-Length : {N}"), 400, LENGTH),
    Case("a length in a folded line", post("Content-Length:", f" {N}"), 400, LENGTH),
    Case("a length of 20 digits", post("Content-Length: 18446744073709551616"), 413, OVER, is_whole=False),
    Case("a length of 20 digits that wraps to the right one", post(f"Content-Length: {2**64 + N}"), 413, OVER, is_whole=False),
    Case("a length of 400 digits", post("Content-Length: " + "9" * 400), 413, OVER, is_whole=False),
    Case("a length that fills 64 bits", post(f"Content-Length: {2**63 - 1}"), 413, OVER, is_whole=False),
    Case("a length one over the limit", post(f"Content-Length: {16 * 1024 * 1024 + 1}", body=b""), 413, OVER + "; " + HEAD_ONLY, is_whole=False),
    Case("a file one over the limit", post(f"Content-Length: {64 * 1024 * 1024 + 1}", body=b"", target="/v1/characters/chains"), 413, OVER, is_whole=False),
    Case("neither length nor chunks", post(), 411, "RFC 9112 6.3, RFC 9110 15.5.12"),
    Case("a length with an underscore", post(f"Content_Length: {N}"), 411, "RFC 9112 6.3: this is some other header"),
    Case("GET with a body", get(f"Content-Length: {N}") + TIMING, 400, NO_BODY),
    Case("GET with a request for a body", get(f"Content-Length: {len(INNOCENT)}") + INNOCENT, 400, NO_BODY),
    Case("GET in chunks", get("Transfer-Encoding: chunked") + b"0\r\n\r\n", 400, NO_BODY),
    Case("HEAD with a body", head("HEAD /v1/version HTTP/1.1", HOST, "Content-Length: 3") + b"abc", 400, NO_BODY),
    Case("OPTIONS with a body", head("OPTIONS /v1/schedules HTTP/1.1", HOST, "Content-Length: 3") + b"abc", 400, NO_BODY),
    Case("OPTIONS in chunks", head("OPTIONS /v1/schedules HTTP/1.1", HOST, "Transfer-Encoding: chunked") + b"0\r\n\r\n", 400, NO_BODY),
    Case("GET with a bad length", get("Content-Length: abc"), 400, LENGTH),
    *(Case(f"coding: {what}", post(f"Transfer-Encoding: {text}", body=chunk(TIMING) + b"0\r\n\r\n"), 400, CODING) for what, text in _CODINGS.items()),
    Case("chunks and a length", post("Transfer-Encoding: chunked", f"Content-Length: {N}", body=chunk(TIMING) + b"0\r\n\r\n"), 400, CODING),
    Case("a length and chunks", post(f"Content-Length: {N}", "Transfer-Encoding: chunked", body=chunk(TIMING) + b"0\r\n\r\n"), 400, CODING),
    Case("smuggling by chunks that end early", post("Content-Length: 6", "Transfer-Encoding: chunked", body=b"0\r\n\r\nG"), 400, CODING),
    Case("smuggling by a length that ends early", post("Content-Length: 4", "Transfer-Encoding: chunked", body=b"2d\r\n" + INNOCENT + b"\r\n0\r\n\r\n"), 400, CODING),
    Case("two codings", post("Transfer-Encoding: chunked", "Transfer-Encoding: chunked", body=chunk(TIMING) + b"0\r\n\r\n"), 400, CODING),
    Case("two codings, the second none", post("Transfer-Encoding: chunked", "Transfer-Encoding: identity", body=chunk(TIMING) + b"0\r\n\r\n"), 400, CODING),
    Case("a coding with a space before its colon", post("Transfer-Encoding : chunked", body=b"0\r\n\r\n"), 400, CODING),
    Case("a coding behind a bare LF", post(f"Content-Length: {N}", b"X: y\nTransfer-Encoding: chunked"), 400, CODING),
    Case("a coding in 1.0", post("Transfer-Encoding: chunked", body=chunk(TIMING) + b"0\r\n\r\n", version="1.0"), 400, CODING),
    *(Case(f"chunk size with {what}", chunked(size.encode() + b"\r\n{    \r\n"), 400, CHUNK) for what, size in _SIZES.items()),
    Case("a chunk size ended by a bare LF", chunked(b"5\n{    \r\n"), 400, CHUNK),
    Case("a chunk size ended by CR CR LF", chunked(b"5\r\r\n{    \r\n"), 400, CHUNK),
    Case("a chunk ended by a bare LF", chunked(b"5\r\n{    \n"), 400, CHUNK),
    Case("a chunk longer than its size", chunked(b"4\r\n{    \r\n"), 400, CHUNK),
    Case("a chunk shorter than its size", chunked(b"6\r\n{    \r\n"), 400, CHUNK),
    Case("a chunk of 2^64 - 1 bytes", chunked(b"ffffffffffffffff\r\n{    \r\n"), 413, OVER, is_whole=False),
    Case("a chunk of 2^63 bytes", chunked(b"8000000000000000\r\n{    \r\n"), 413, OVER, is_whole=False),
    Case("a chunk one over the limit", chunked(b"1000001\r\n{    \r\n"), 413, OVER, is_whole=False),
    Case("a second chunk over the limit", chunked(FIVE, b"fffffc\r\n{    \r\n"), 413, OVER, is_whole=False),
    Case("a control character in an extension", chunked(b"5;a=\x01\r\n{    \r\n"), 400, CHUNK),
    Case("a bare CR in an extension", chunked(b"5;a\rb\r\n{    \r\n"), 400, CHUNK),
    Case("a bare LF in an extension", chunked(b"5;a\nb\r\n{    \r\n"), 400, CHUNK),
    Case("bytes in an extension", chunked(b"5;a=\xff\r\n{    \r\n"), 400, CHUNK),
    Case("an extension of 300 bytes", chunked(b"5;" + b"a" * 300 + b"\r\n{    \r\n"), 400, CHUNK + ", our limit is 256 bytes"),
    Case("an extension that never ends", chunked(b"5;" + b"a" * 1_000, end=b""), 400, CHUNK, is_whole=False),
    Case("a trailer with a bare LF", chunked(chunk(TIMING), end=b"0\r\nX: y\n\r\n"), 400, "RFC 9112 7.1.2, 2.2"),
    Case("17 trailers", chunked(chunk(TIMING), end=b"0\r\n" + b"X: y\r\n" * 17 + b"\r\n"), 400, "RFC 9112 7.1.2, our limit is 16 lines"),
    Case("the empty line after the last chunk missing", chunked(chunk(TIMING), end=b"0\r\nGET /v1/version HTTP/1.1\n\r\n"), 400, "RFC 9112 7.1"),
    *(Case(f"packed with {word}", sized(f"Content-Encoding: {word}"), 415, PACKED) for word in ("gzip", "br", "deflate", "zstd", "x-gzip", "gzip, identity", "compress", "tea")),
    Case("packed and in chunks", chunked(chunk(TIMING), lines=("Content-Encoding: gzip",)), 415, PACKED),
    Case("GET of an operation", get(target="/v1/tufts"), 405, "RFC 9110 15.5.6", may_go_on=True),
    Case("HEAD of an operation", head("HEAD /v1/tufts HTTP/1.1", HOST), 405, "RFC 9110 15.5.6", may_go_on=True),
    Case("POST to what is only read", sized(target="/v1/version"), 405, "RFC 9110 15.5.6", may_go_on=True),
    Case("POST to what is only read, its body to come", post("Content-Length: 1000000", body=b"", target="/v1/version"), 405, HEAD_ONLY, is_whole=False),
    Case("nothing there", get(target="/v1/nothing"), 404, "RFC 9110 15.5.5", may_go_on=True),
    Case("a path that climbs", get(target="/docs/../../etc/passwd"), 404, "RFC 9110 15.5.5", may_go_on=True),
    Case("an encoded path that climbs", get(target="/docs/..%2f..%2fetc%2fpasswd"), 404, "RFC 9110 15.5.5", may_go_on=True),
    Case("two slashes", get(target="//v1/version"), 404, "RFC 9110 15.5.5", may_go_on=True),
    Case("other case", get(target="/V1/Version"), 404, "RFC 9110 4.2.3: paths are case-sensitive", may_go_on=True),
    Case("a target of 2,048 bytes", get(target="/" + "a" * 2_047), 404, "RFC 9110 15.5.5: as long as it may be", may_go_on=True),
    Case("nothing to POST to, its body to come", post("Content-Length: 1000000", body=b"", target="/v1/nothing"), 404, HEAD_ONLY, is_whole=False),
    Case("nothing to POST to, its body never to come", post(f"Content-Length: {2**40}", body=b"", target="/v1/nothing"), 404, HEAD_ONLY, is_whole=False),
]
