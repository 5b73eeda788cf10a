"""Many clients that send a byte a second, in a process of their own so that they disturb nobody's clock.

    python3 tests/edge/slow_clients.py --port PORT --clients 4000 --seconds 30

A third each: the head never ends; the body never ends; every twentieth sends more than the proxy holds back and then
slows down. Who is cut comes again until the time is over. Prints one JSON object: how many were open at once, how many
were cut, the longest that one lasted (seconds), how many were still open when that took 20 s.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import sys
import time
from typing import Optional

from attacks import BEYOND_BUFFER

LONGEST_S = 20.0
PER_SECOND = 1000  # new connections
HEAD = b"POST /v1/schedules HTTP/1.1\r\nHost: tuftwave.test\r\nContent-Type: application/json\r\n"


def beginning(kind: int) -> bytes:
    if kind % 20 == 0:
        return HEAD + b"Content-Length: 1000000\r\n\r\n" + b" " * BEYOND_BUFFER
    return HEAD + (b"Content-Length: 1000\r\n\r\n{" if kind % 2 else b"X-Slow: ")


class Crowd:
    def __init__(self, port: int, clients: int, seconds: float) -> None:
        self._port, self._clients, self._end = port, clients, time.monotonic() + seconds
        self.opened = self.now_open = self.most_open = self.cut = self.survived = self.not_connected = 0
        self.longest_s = 0.0

    async def run(self) -> None:
        await asyncio.gather(*(self._client(number) for number in range(self._clients)))

    async def _client(self, number: int) -> None:
        await asyncio.sleep(number / PER_SECOND)
        while time.monotonic() < self._end:
            try:
                reader, writer = await asyncio.open_connection("127.0.0.1", self._port)
            except OSError:
                self.not_connected += 1
                await asyncio.sleep(1)
                continue
            self.opened += 1
            self.now_open += 1
            self.most_open = max(self.most_open, self.now_open)
            begun = time.monotonic()
            self._count(await self._is_cut(reader, writer, number, begun), time.monotonic() - begun)
            writer.close()
            self.now_open -= 1

    async def _is_cut(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, number: int, begun: float) -> bool:
        closed = asyncio.ensure_future(self._closed(reader))
        try:
            writer.write(beginning(number))
            while time.monotonic() - begun < LONGEST_S:
                done, _ = await asyncio.wait({closed}, timeout=1)
                if done:
                    return True
                writer.write(b"a")
            return False
        except OSError:
            return True
        finally:
            closed.cancel()

    @staticmethod
    async def _closed(reader: asyncio.StreamReader) -> None:
        try:
            while await reader.read(65536):
                pass
        except OSError:
            pass

    def _count(self, is_cut: bool, seconds: float) -> None:
        self.longest_s = max(self.longest_s, seconds)
        if is_cut:
            self.cut += 1
        else:
            self.survived += 1


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Clients that send a byte a second.")
    parser.add_argument("--port", type=int, required=True)
    parser.add_argument("--clients", type=int, required=True)
    parser.add_argument("--seconds", type=float, required=True, help="how long to come again after being cut")
    options = parser.parse_args(arguments)
    crowd = Crowd(options.port, options.clients, options.seconds)
    asyncio.run(crowd.run())
    print(json.dumps({"most_open": crowd.most_open, "opened": crowd.opened, "cut": crowd.cut, "survived": crowd.survived,
                      "not_connected": crowd.not_connected, "longest_s": round(crowd.longest_s, 1)}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
