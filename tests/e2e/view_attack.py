"""`scree view` under attacks that a web page, a program or another user of this machine could make: foreign Host and
Origin, paths with `..`, tens of thousands of damaged requests, WebSocket frames that violate the protocol. The program
must refuse each, disclose no file of the file system, and serve the next valid request.
Usage: view_attack.py SCREE SOURCE [REQUESTS]    REQUESTS: damaged ones of each server, 10000
"""

import os
import random
import re
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

SCREE, SOURCE = sys.argv[1:3]
REQUESTS = int(sys.argv[3]) if len(sys.argv) > 3 else 10000
SECRET = "root:x:0:0:"  # beginning of /etc/passwd, which no reply may contain
GET = "GET {path} HTTP/1.1\r\nHost: {host}\r\n{more}\r\n"
KEY = "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"

STARTED = []  # programs


def fail(text):
    sys.exit(f"view_attack: FAILED: {text}")


class Server:
    """A running `scree view`, with the port that it prints."""

    def __init__(self, *words):
        self.program = subprocess.Popen([SCREE, "view", *words], stdout=subprocess.PIPE, text=True)
        STARTED.append(self.program)
        for line in self.program.stdout:
            found = re.search(r"http://127\.0\.0\.1:(\d+)/(?:#token=(\w+))?", line)
            if found:
                self.port, self.token = int(found[1]), found[2]
                return
        fail(f"view {words} ends with {self.program.wait()}")

    @property
    def host(self):
        return f"127.0.0.1:{self.port}"

    @property
    def origin(self):
        return f"Origin: http://{self.host}\r\n"

    def get(self, path="/", host=None, more=""):
        return GET.format(path=path, host=self.host if host is None else host, more=more)

    def upgrade(self, origin=None, path="/live"):
        return self.get(path, more=f"Upgrade: websocket\r\nConnection: Upgrade\r\n{KEY}{self.origin if origin is None else origin}")

    def ask(self, request, wait=3.0):
        """Sends bytes, closes the sending side, and returns the whole answer until the connection ends or the time
        limit is reached."""
        if isinstance(request, str):
            request = request.encode("latin-1")
        with socket.create_connection(("127.0.0.1", self.port), timeout=wait) as s:
            return self.rest(s, request)

    def talk(self, frames, wait=1.0):
        """Opens the WebSocket, sends bytes once it is open, and waits until the server ends it."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=wait) as s:
            s.sendall(self.upgrade().encode())
            return s.recv(4096) + self.rest(s, frames)

    @staticmethod
    def rest(s, bytes_):
        """Sends bytes, closes the sending side, and returns the received data until the connection ends or the time
        limit is reached."""
        out = b""
        try:
            s.sendall(bytes_)
            s.shutdown(socket.SHUT_WR)
            while part := s.recv(65536):
                out += part
        except OSError:
            pass
        return out

    def memory(self):
        with open(f"/proc/{self.program.pid}/status") as text:
            return int(re.search(r"VmRSS:\s+(\d+)", text.read())[1]) / 1024

    def alive(self, what):
        if self.program.poll() is not None:
            fail(f"the server ended with {self.program.returncode}: {what}")
        reply = self.ask(self.get(more="Connection: close\r\n"))
        if not reply.startswith(b"HTTP/1.1 200") or b"</html>" not in reply[-200:]:
            fail(f"the page is not served any more: {what}: {reply[:200]!r}")

    def end(self):
        STARTED.remove(self.program)
        self.program.send_signal(signal.SIGINT)
        code = self.program.wait(20)
        if code != 0:
            fail(f"view ends with {code}")


def code_of(reply):
    found = re.match(rb"HTTP/1\.[01] (\d{3}) ", reply)
    return int(found[1]) if found else 0


def frame(payload, opcode=1, masked=True, last=True, length=None, reserved=0):
    """A WebSocket frame of a client, valid or not."""
    if isinstance(payload, str):
        payload = payload.encode()
    size = len(payload) if length is None else length
    head = bytes([(0x80 if last else 0) | reserved << 4 | opcode])
    flag = 0x80 if masked else 0
    head += bytes([flag | size]) if size < 126 else bytes([flag | 126]) + struct.pack(">H", size) if size < 65536 else bytes([flag | 127]) + struct.pack(">Q", size)
    mask = b"\x11\x22\x33\x44"
    return head + (mask + bytes(b ^ mask[i % 4] for i, b in enumerate(payload)) if masked else payload)


def refuse(server, request, codes, what):
    reply = server.ask(request)
    if code_of(reply) not in codes:
        fail(f"{what}: {code_of(reply)}, not one of {codes}: {reply[:300]!r}")
    if SECRET.encode() in reply:
        fail(f"{what}: gives the password file")


def attack_headers(server):
    other = server.port + 1 if server.port < 65535 else 1024
    hosts = ["evil.example", f"evil.example:{server.port}", "127.0.0.1", "localhost", f"127.0.0.1:{other}", f"[::1]:{server.port}", f"127.0.0.1.evil.example:{server.port}",
             f"evil.example@127.0.0.1:{server.port}", f"127.0.0.1:{server.port}@evil.example", f"0.0.0.0:{server.port}", f"127.0.0.2:{server.port}", f"127.1:{server.port}",
             f"2130706433:{server.port}", f"127.0.0.1:0{server.port}", f"127.0.0.1:{server.port}.", "", "*", f"localhost.:{server.port}"]
    for host in hosts:
        refuse(server, server.get(host=host), {400, 403, 421}, f"Host {host!r}")
    refuse(server, "GET / HTTP/1.1\r\n\r\n", {400, 403, 421}, "no Host")
    refuse(server, server.get(more="Host: evil.example\r\n"), {400, 403, 421}, "two Hosts")
    origins = ["http://evil.example", "https://" + server.host, f"http://{server.host}.evil.example", f"http://127.0.0.1:{other}", "null", "", "file://", f"http://evil.example/http://{server.host}"]
    for origin in origins:
        refuse(server, server.get(more=f"Origin: {origin}\r\n"), {403}, f"Origin {origin!r}")
        refuse(server, server.upgrade(f"Origin: {origin}\r\n"), {403, 404}, f"WebSocket of Origin {origin!r}")
    refuse(server, server.upgrade(""), {403, 404}, "WebSocket without Origin")
    refuse(server, server.upgrade(server.origin + "Origin: http://evil.example\r\n"), {403, 404}, "WebSocket of two Origins")
    for method in ["POST", "PUT", "DELETE", "OPTIONS", "CONNECT", "TRACE", "PROPFIND", "G\x00T"]:
        refuse(server, server.get().replace("GET", method, 1), {400, 403, 405}, f"method {method!r}")
    refuse(server, server.get(more="Content-Length: 5\r\n") + "hello", {400, 413}, "a body")
    refuse(server, server.get(more="Content-Length: 99999999999999999999\r\n"), {400, 413}, "a body beyond all numbers")
    refuse(server, server.get(more="Transfer-Encoding: chunked\r\n") + "5\r\nhello\r\n0\r\n\r\n", {400, 413}, "a body in chunks")
    refuse(server, server.get(more="X: " + "a" * 20000 + "\r\n"), {400, 431}, "a header of 20 kB")
    refuse(server, server.get("/" + "a" * 20000), {400, 414, 431}, "a path of 20 kB")


def attack_paths(server):
    climbs = ["/../../../../etc/passwd", "/..%2f..%2f..%2f..%2fetc%2fpasswd", "/%2e%2e/%2e%2e/%2e%2e/etc/passwd", "/....//....//etc/passwd", "//etc/passwd", "/./../etc/passwd", "/viewer.js/../../etc/passwd",
              "/frame/../../../../../etc/passwd", "/frame/%00", "/frame/-1", "/frame/99999999999999999999", "/frame/0x1", "/frame/1/../../x", "/mesh/1e3", "/frame/00", "/frame/ 1", "\\..\\..\\etc\\passwd",
              "/..\\..\\..\\etc\\passwd", "file:///etc/passwd", "http://evil.example/", "/%c0%ae%c0%ae/etc/passwd", "/run.json%00.html", "/run.vtkhdf", "/run.log", "/case.toml", "/?file=/etc/passwd",
              "/viewer.js?/../../etc/passwd", "/left/../../../etc/passwd", "/proc/self/environ", "*"]
    for path in climbs:
        refuse(server, server.get(path), {400, 403, 404, 421}, f"path {path!r}")


def attack_socket(server):
    """Frames that violate the protocol or the limits: the connection is closed; the server continues."""
    cases = {
        "unmasked": frame("n", masked=False), "reserved bits": frame("n", reserved=7), "reserved opcode": frame("n", opcode=5), "text that is no UTF-8": frame(b"\xff\xfe\xfd"),
        "a message of 64 kB": frame("n" * 65000), "a claim of 2^62 bytes": frame("n", length=1 << 62), "a claim of 2^64 - 1 bytes": frame("n", length=(1 << 64) - 1),
        "continuation of nothing": frame("n", opcode=0), "two beginnings": frame("n", last=False) + frame("n"), "fragments without end": frame("n", last=False) + frame("n", 0, last=False) * 5000,
        "a ping of 200 bytes": frame(b"p" * 200, opcode=9), "a ping in pieces": frame("p", opcode=9, last=False), "a close of one byte": frame(b"\x03", opcode=8), "a close of a forbidden code": frame(struct.pack(">H", 1005), opcode=8),
        "a thousand pings": frame(b"p", opcode=9) * 1000, "words": frame("stop"), "another token": frame("0" * 32 + " stop"), "script": frame("<script>alert(1)</script>"), "escapes": frame("\x1b]0;owned\x07\x1b[2J"),
        "two takes too many": frame("n") * 50, "garbage": os.urandom(4096), "nothing": b"",
    }
    for what, bytes_ in cases.items():
        reply = server.talk(bytes_)
        if code_of(reply) != 101:
            fail(f"no WebSocket for {what}: {reply[:200]!r}")
        if server.program.poll() is not None:
            fail(f"the server ended with {server.program.returncode}: {what}")
    server.alive("after frames that break the protocol")


PIECES = [b"\r\n", b"\r\n\r\n", b"\0", b"HTTP/1.1", b"HTTP/9.9", b"Host: ", b"Origin: http://evil.example\r\n", b"../", b"%2e%2e/", b"Content-Length: 7\r\n", b"Transfer-Encoding: chunked\r\n", b"\xff\xfe", b" ", b":", b"\t",
          b"Connection: close\r\n", b"GET / HTTP/1.1\r\n", b"Expect: 100-continue\r\n", b"Upgrade: h2c\r\n", b"Range: bytes=0-1\r\n", b"\x1b[2J", b"A" * 9000, b"\n", b"\r"]


def damaged(seed, rng):
    text = bytearray(seed)
    for _ in range(rng.randint(1, 4)):
        at = rng.randrange(len(text) + 1)
        how = rng.randrange(6)
        if how == 0 and at < len(text):
            text[at] = rng.randrange(256)
        elif how == 1:
            del text[at : at + rng.randint(1, 20)]
        elif how == 2:
            text[at:at] = rng.choice(PIECES)
        elif how == 3:
            text[at:at] = text[at : at + rng.randint(1, 60)]
        elif how == 4:
            del text[max(1, at) :]
        else:
            text[at:at] = bytes([rng.randrange(256)]) * rng.randint(1, 300)
    return bytes(text)


def attack_random(server, count, has_socket):
    rng = random.Random(20261124)
    seeds = [server.get().encode(), server.get("/viewer.css", more=server.origin).encode(), server.get("/frame/1").encode(), server.get("/run.json").replace("GET", "HEAD", 1).encode()]
    if has_socket:
        seeds += [server.upgrade().encode(), server.upgrade().encode() + frame("n") + frame("n"), server.upgrade().encode() + frame("x" * 9)]
    codes = {}
    before = server.memory()
    begin = time.monotonic()
    for i in range(count):
        request = damaged(seeds[i % len(seeds)], rng)
        s = socket.create_connection(("127.0.0.1", server.port), timeout=5)
        reply = b""
        try:
            s.sendall(request)
            s.shutdown(socket.SHUT_WR)
            reply = s.recv(4096)
        except OSError:
            pass
        s.close()
        code = code_of(reply)
        codes[code] = codes.get(code, 0) + 1
        if SECRET.encode() in reply:
            fail(f"request {i} gives the password file: {request!r}")
        if code == 200 and server.host.encode() not in request and f"localhost:{server.port}".encode() not in request.lower():
            fail(f"request {i} is answered without naming this server: {request!r}")
        if i % 1000 == 999:
            server.alive(f"after {i + 1} damaged requests")
    grown = server.memory() - before
    print(f"{count} damaged requests in {time.monotonic() - begin:.1f} s: codes {dict(sorted(codes.items()))}; memory {before:.0f} MB, grown by {grown:.1f} MB")
    for code in (200, 400, 404, 421):
        if not codes.get(code):
            fail(f"no damaged request was answered with {code}: the seeds say nothing")
    if grown > 30:
        fail(f"memory has grown by {grown:.0f} MB")


def attack_crowd(server):
    """More connections than the server keeps, all idle; they are refused or wait, and the next page is served when they
    are closed."""
    crowd = [socket.create_connection(("127.0.0.1", server.port), timeout=5) for _ in range(400)]
    for s in crowd[::2]:
        s.sendall(b"GET / HT")
    time.sleep(0.3)
    if server.program.poll() is not None:
        fail("the server ended in a crowd")
    for s in crowd:
        s.close()
    for _ in range(50):  # the server detects one closed connection after the other
        if code_of(server.ask(server.get(more="Connection: close\r\n"))) == 200:
            break
        time.sleep(0.05)
    server.alive("after a crowd of silent connections")


def attack(server, has_socket):
    server.alive("at first")
    attack_headers(server)
    attack_paths(server)
    if has_socket:
        attack_socket(server)
    attack_random(server, REQUESTS, has_socket)
    attack_crowd(server)
    # The server listens on 127.0.0.1 only, on no other address of this machine.
    listening = [line.split()[1] for table in ("tcp", "tcp6") for line in open(f"/proc/{server.program.pid}/net/{table}").readlines()[1:] if line.split()[3] == "0A"]
    mine = [a for a in listening if int(a.split(":")[1], 16) == server.port]
    if mine != [f"0100007F:{server.port:04X}"]:
        fail(f"listens on {mine}, not on 127.0.0.1 alone")


def main():
    case = f"{SOURCE}/tests/e2e/report/case.toml"
    with tempfile.TemporaryDirectory() as scratch:
        run, log = f"{scratch}/run", f"{scratch}/run.log"
        env = {**os.environ, "OMP_NUM_THREADS": "1"}
        subprocess.run([SCREE, "run", case, "--out", run, "--quiet", f"--live=file://{log}"], check=True, env=env, stderr=subprocess.DEVNULL)
        stored = Server(run)
        attack(stored, has_socket=False)
        stored.end()
        live = Server(f"--live=file://{log}")
        attack(live, has_socket=True)
        live.end()
    print("view attacked: fine")


try:
    main()
finally:
    for program in STARTED:
        program.kill()
