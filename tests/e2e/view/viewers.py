#!/usr/bin/env python3
"""Viewers of `scree view --live` without a browser: each connects its WebSocket, receives messages and acknowledges them, as the page does.

usage: viewers.py ADDRESS COUNT     until it is ended; prints messages and bytes of all of them a second, at its end in all
"""
import base64
import os
import selectors
import signal
import socket
import struct
import sys
import time
from urllib.parse import urlsplit


class Viewer:
    def __init__(self, host, port):
        self.socket = socket.create_connection((host, port))
        self.socket.sendall((f"GET /live HTTP/1.1\r\nHost: {host}:{port}\r\nOrigin: http://{host}:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                             f"Sec-WebSocket-Key: {base64.b64encode(os.urandom(16)).decode()}\r\nSec-WebSocket-Version: 13\r\n\r\n").encode())
        self.bytes = b""
        self.open = False
        self.frames = 0

    def send(self, opcode, payload):
        mask = os.urandom(4)
        self.socket.sendall(bytes([0x80 | opcode, 0x80 | len(payload)]) + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(payload)))

    def take(self):
        """Handles the received data. Returns the lengths of the messages."""
        some = self.socket.recv(1 << 18)
        if not some:
            raise ConnectionError("the server has closed the connection")
        self.bytes += some
        if not self.open:
            end = self.bytes.find(b"\r\n\r\n")
            if end < 0:
                return []
            if not self.bytes.startswith(b"HTTP/1.1 101"):
                raise ConnectionError(self.bytes.decode(errors="replace"))
            self.bytes, self.open = self.bytes[end + 4:], True
        lengths = []
        while len(self.bytes) >= 2:
            opcode, length, at = self.bytes[0] & 15, self.bytes[1] & 127, 2
            if length >= 126:
                width = 2 if length == 126 else 8
                if len(self.bytes) < 2 + width:
                    break
                length, at = int.from_bytes(self.bytes[2:2 + width], "big"), 2 + width
            if len(self.bytes) < at + length:
                break
            message, self.bytes = self.bytes[at:at + length], self.bytes[at + length:]
            if opcode == 9:
                self.send(10, message)
            elif opcode == 2:
                lengths.append(length)
                head = message[4:4 + struct.unpack_from("<I", message)[0]]
                self.frames += b'"kind":"frame"' in head
                if b'"kind":"frame"' in head or b'"kind":"detail"' in head:
                    self.send(1, b"n")
        return lengths


def main():
    address, count = urlsplit(sys.argv[1]), int(sys.argv[2])
    viewers = [Viewer(address.hostname, address.port) for _ in range(count)]
    selector = selectors.DefaultSelector()
    for v in viewers:
        selector.register(v.socket, selectors.EVENT_READ, v)
    stop = []
    for s in (signal.SIGTERM, signal.SIGINT):
        signal.signal(s, lambda *_: stop.append(True))
    total = messages = 0
    begin = time.time()
    while not stop and selector.get_map():
        for key, _ in selector.select(0.1):
            try:
                lengths = key.data.take()
            except (ConnectionError, OSError):
                selector.unregister(key.fileobj)
                continue
            messages, total = messages + len(lengths), total + sum(lengths)
    frames = [v.frames for v in viewers]
    print(f"{count} viewers, {time.time() - begin:.1f} s: {messages} messages, {total / 1e6:.1f} MB, {min(frames)} to {max(frames)} frames each", flush=True)


main()
