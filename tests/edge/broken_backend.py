"""A server as it must not be: it keeps a connection alive without reading the body of what it refuses or need not read.

It shows that the attacks of attacks.py work where they can: behind the same proxy its other clients get wrong answers.
"""

from __future__ import annotations

import json
import re
import socketserver
import threading
from typing import Any

LENGTH = re.compile(rb"\r\ncontent-length: *(\d+)", re.IGNORECASE)


class Handler(socketserver.StreamRequestHandler):
    disable_nagle_algorithm = True

    def handle(self) -> None:
        try:
            while head := self._head():
                self._answer(*self._of(head))
        except OSError:
            pass

    def _head(self) -> bytes:
        head = b""
        while not head.endswith(b"\r\n\r\n"):
            line = self.rfile.readline(65536)
            if not line:
                return b""
            head += line
        return head

    def _of(self, head: bytes) -> tuple[int, bytes]:
        """Status and body. The fault: only the body of a schedule is read."""
        if head.startswith(b"POST /v1/schedules "):
            length = LENGTH.search(head)
            try:
                timing = json.loads(self.rfile.read(int(length[1])) if length else b"{}")["timing"]
                return 200, json.dumps({"schedule": {"requested_period": timing["period"]}}).encode()
            except (ValueError, LookupError, TypeError):
                return 400, b"{}"
        return 200 if head.startswith(b"GET ") else 404, b"ready\n"

    def _answer(self, status: int, body: bytes) -> None:
        self.wfile.write(f"HTTP/1.1 {status} X\r\nContent-Length: {len(body)}\r\n\r\n".encode() + body)


class BrokenBackend:
    def __enter__(self) -> "BrokenBackend":
        class Server(socketserver.ThreadingTCPServer):
            daemon_threads = True
            request_queue_size = 128

        self._server = Server(("127.0.0.1", 0), Handler)
        self.port: int = self._server.server_address[1]
        threading.Thread(target=self._server.serve_forever, daemon=True).start()
        return self

    def __exit__(self, *_: Any) -> None:
        self._server.shutdown()
        self._server.server_close()
