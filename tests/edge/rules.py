"""What the proxy itself refuses, says and hides."""

from __future__ import annotations

from edge import Edge, Proxy
from wire import Answer, Broken, Connection, request, schedule

LIMIT = 20


def check_rules(edge: Edge, _: bool) -> tuple[bool, str]:
    faults: list[str] = []
    behind = [(edge.replicas[0].port, edge.replicas[0].admin_port)]
    with Proxy(behind, TUFTWAVE_SOURCE_CONNECTIONS=str(LIMIT)) as proxy:
        too_large(proxy, faults)
        malformed(proxy, faults)
        no_leaks(proxy, faults)
        too_many_connections(proxy, faults)
        nobody_there(edge, proxy, faults)
    with Proxy(behind, TUFTWAVE_SOURCE_REQUESTS=str(LIMIT)) as proxy:
        too_many_requests(proxy, faults)
    return not faults, f"heads, sources, own errors, headers: {len(faults)} faults {faults or ''}".rstrip()


def too_large(proxy: Proxy, faults: list[str]) -> None:
    expect_problem(ask(proxy, request("GET", "/v1/version", None, "X: " + "a" * 17_000)), 431, "headers_too_large", faults)
    expect_problem(ask(proxy, request("GET", "/v1/version", None, *["X: a"] * 70)), 431, "headers_too_large", faults)


def malformed(proxy: Proxy, faults: list[str]) -> None:
    """What is no HTTP never gets to a replica; HAProxy words this answer before it knows of any configuration."""
    answer = ask(proxy, b"GET /v1/version HTTP/1.1\r\nHost: a\r\nno colon\r\n\r\n")
    if answer.status != 400:
        faults.append(f"malformed: {answer.status}")


def no_leaks(proxy: Proxy, faults: list[str]) -> None:
    answer = ask(proxy, request("GET", "/v1/version", None, "X-Forwarded-For: 10.0.0.1"))
    leaks = {"server", "via", "x-powered-by", "keep-alive"} & set(answer.headers)
    if answer.status != 200 or leaks:
        faults.append(f"leaks: {answer.status} {sorted(leaks)}")


def is_served(connection: Connection) -> bool:
    try:
        connection.ask(request("GET", "/v1/version"))
        return True
    except (Broken, OSError):
        return False


def too_many_connections(proxy: Proxy, faults: list[str]) -> None:
    crowd = [proxy.connect() for _ in range(LIMIT)]
    try:
        for connection in crowd:
            connection.send(b"G")
        # HAProxy may have counted connections that had just been closed when the crowd came, and refused some of it.
        for _ in range(LIMIT):
            crowd.append(proxy.connect())
            if not is_served(crowd[-1]):
                return
        faults.append(f"{LIMIT} connections too many were served")
    finally:
        for connection in crowd:
            connection.close()


def too_many_requests(proxy: Proxy, faults: list[str]) -> None:
    answers = [ask(proxy, schedule(number)) for number in range(2 * LIMIT)]
    refused = [answer for answer in answers if answer.status != 200]
    if not LIMIT // 2 <= len(refused) < len(answers):
        faults.append(f"{len(refused)} of {len(answers)} requests refused")
    for answer in refused[:1]:
        expect_problem(answer, 429, "over_share", faults)
        if not answer.headers.get("retry-after", "").isdigit():
            faults.append("429 without Retry-After")


def nobody_there(edge: Edge, proxy: Proxy, faults: list[str]) -> None:
    edge.replicas[0].kill()
    answer = ask(proxy, schedule(1))
    edge.replicas[0].start()
    expect_problem(answer, 503, "busy", faults)
    if not answer.headers.get("retry-after", "").isdigit():
        faults.append("503 without Retry-After")


def ask(proxy: Proxy, data: bytes) -> Answer:
    with Connection(proxy.address, 10) as connection:
        return connection.ask(data)


def expect_problem(answer: Answer, status: int, slug: str, faults: list[str]) -> None:
    if (answer.status, answer.headers.get("content-type")) != (status, "application/problem+json"):
        faults.append(f"{answer.status} {answer.headers.get('content-type')} instead of {status} {slug}")
        return
    problem = answer.json()
    got = (problem["type"], problem["status"], problem["request_id"], answer.headers.get("cache-control"))
    wanted = ("urn:tuftwave:problem:" + slug, status, answer.headers.get("request-id"), "no-store")
    if got != wanted or not {"title", "detail"} <= set(problem):
        faults.append(f"{got} instead of {wanted}")
