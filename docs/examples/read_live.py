#!/usr/bin/env python3
"""Receives the messages of a run that streams (scree run --live). It needs Python alone, without LCM or other packages.

    read_live.py [--run NAME] [--group 239.255.76.67:7667] [--for SECONDS] [--timeout SECONDS] [--state FILE.json]

It prints one line for every INFO message and every event, and ends when the run has ended; with --state it then writes
the last frame, the monitors and the energy ledger to a file. The types of the messages are defined by the files in
io/lcmtypes (installed: share/scree/lcmtypes), which it reads; --types gives another folder for them."""
import argparse
import collections
import json
import pathlib
import re
import socket
import struct
import sys
import time
import zlib

# --- types: fields (type, name, sizes) read from <name>.lcm, and the fingerprint at the start of a message --------------

NUMBERS = {"int8_t": "b", "int16_t": "h", "int32_t": "i", "int64_t": "q", "float": "f", "double": "d", "byte": "B"}
PRIMITIVE = {*NUMBERS, "string", "boolean"}
Field = collections.namedtuple("Field", "type name sizes")


def read_types(folder):
    types = {}
    for path in sorted(pathlib.Path(folder).glob("*.lcm")):
        text = re.sub(r"//.*", "", path.read_text())
        for name, body in re.findall(r"struct\s+(\w+)\s*\{([^}]*)\}", text):
            fields = re.findall(r"(\w+)\s+(\w+)\s*((?:\[\w+\])*)\s*;", body)
            types[name] = [Field(kind, field, re.findall(r"\[(\w+)\]", sizes)) for kind, field, sizes in fields]
    return types


def fingerprint(types, name):
    """Fingerprint of a message type, as lcm-gen computes it in signed 64-bit arithmetic."""
    def signed(v):
        v &= (1 << 64) - 1
        return v - (1 << 64) if v >> 63 else v

    def add(v, byte):
        return signed((signed(v << 8) ^ (v >> 55)) + byte)

    def add_text(v, text):
        v = add(v, len(text))
        for c in text.encode():
            v = add(v, c)
        return v

    v, inner = 0x12345678, 0
    for field in types[name]:
        v = add_text(v, field.name)
        if field.type in PRIMITIVE:
            v = add_text(v, field.type)
        else:
            inner += fingerprint(types, field.type)
        v = add(v, len(field.sizes))
        for size in field.sizes:
            v = add_text(add(v, 0 if size.isdigit() else 1), size)
    v = (v + inner) & (1 << 64) - 1
    return (v << 1 | v >> 63) & (1 << 64) - 1


class Malformed(Exception):
    pass


class Decoder:
    def __init__(self, types):
        self.types = types
        self.fingerprints = {name: struct.pack(">Q", fingerprint(types, name)) for name in types}

    def message(self, name, data):
        """Fields of a complete message as a dict. Raises Malformed if the message is not valid."""
        if len(data) < 12 or data[:8] != self.fingerprints[name]:
            raise Malformed("wrong fingerprint")
        if struct.unpack(">I", data[-4:])[0] != zlib.crc32(data[:-4]):
            raise Malformed("wrong CRC")
        self.data, self.at = data, 8
        fields = self.fields(name)
        if self.at != len(data):
            raise Malformed("wrong length")
        return fields

    def take(self, count):
        if count < 0 or self.at + count > len(self.data):
            raise Malformed("a field extends beyond the end of the message")
        self.at += count
        return self.data[self.at - count:self.at]

    def fields(self, name):
        out = {}
        for field in self.types[name]:
            count = 1
            for size in field.sizes:
                count *= int(size) if size.isdigit() else out[size]
            if count < 0:
                raise Malformed("negative number of elements")
            if field.type in NUMBERS:
                code = struct.Struct(f">{count}{NUMBERS[field.type]}")
                values = code.unpack(self.take(code.size))
            elif field.type == "string":
                values = []
                for _ in range(count):
                    size = struct.unpack(">i", self.take(4))[0]
                    values.append(self.take(size)[:-1].decode(errors="replace"))
            else:
                values = [self.fields(field.type) for _ in range(count)]
            out[field.name] = values if field.sizes else values[0]
        return out


# --- meshes and frames, as io/lcmtypes/{topo,mesh,state}_v1_t.lcm define them -------------------------------------------


class Run:
    """The newest messages of the present session. A newer session replaces the present one at once; an older session
    replaces it only if the present one has sent nothing for 3 s and has not reported its end."""

    def __init__(self, decoder):
        self.decoder, self.session, self.heard, self.malformed, self.frames = decoder, -1, 0, 0, 0
        self.forget()

    def forget(self):
        self.info = self.energy = self.mesh = self.frame = self.history = None
        self.events, self.mesh_chunks, self.state_chunks, self.hist_parts = {}, {}, {}, {}

    def take(self, kind, data):
        """True if a message was accepted."""
        try:
            message = self.decoder.message(f"{kind.lower()}_v1_t", data)
            header = message["header"]
            now = int(time.time() * 1e6)
            if header["session"] > now + 60_000_000 or header["sequence"] > now - header["session"] + 60_000_000:
                raise Malformed("time in the future")  # if accepted, all correct messages after it would seem outdated
            going_on = not self.info or self.info["status"] in ("running", "paused")
            if header["session"] < self.session and not (going_on and now - self.heard > 3_000_000):
                return False
            if header["session"] != self.session:
                self.session = header["session"]
                self.forget()
            self.heard = now
            getattr(self, "take_" + kind.lower())(message, header)
            return True
        except (Malformed, KeyError, IndexError, ValueError) as wrong:
            self.malformed += 1
            print(f"rejected a message of kind {kind}: {wrong}", file=sys.stderr)
            return False

    def take_info(self, message, _):
        self.info = message

    def take_energy(self, message, _):
        self.energy = message

    def take_event(self, message, header):
        self.events.setdefault(header["sequence"], message)  # each event is sent repeatedly

    def take_hist(self, message, header):
        if self.history and header["sequence"] <= self.history["sequence"]:
            return
        parts = self.hist_parts.setdefault(header["sequence"], {})
        parts[message["first"]] = message
        if sum(m["monitors"] for m in parts.values()) < message["total"]:
            return
        self.history = {"sequence": header["sequence"], "time": header["time"], "monitors": {}}
        for part in parts.values():
            for i, name in enumerate(part["name"]):
                self.history["monitors"][name] = {
                    what: [part[what + "_x"][i], part[what + "_y"][i]] for what in ("position", "displacement", "velocity")}
        self.hist_parts.clear()

    def take_topo(self, message, header):
        if self.mesh and self.mesh["id"] == header["topology_id"]:
            return
        chunks = self.mesh_chunks.setdefault(header["topology_id"], {})  # a mesh is sent repeatedly, with the same bytes
        chunks[message["chunk"]] = message["data"]
        if len(chunks) < message["chunks"]:
            return
        self.mesh_chunks.clear()
        whole = bytes(b"".join(bytes(chunks[k]) for k in range(message["chunks"])))
        mesh = self.decoder.message("mesh_v1_t", whole)
        # Bodies are the blocks in the order of their first cells. A point belongs to the body of the first cell that
        # contains it.
        bodies, owner, at = {}, {}, 0
        for corners, block in zip(mesh["corners"], mesh["block"]):
            body = bodies.setdefault(block, len(bodies))
            for point in mesh["connectivity"][at:at + corners]:
                owner.setdefault(point, body)
            at += corners
        mesh["points_of"] = [[] for _ in bodies]
        for point in sorted(owner):
            mesh["points_of"][owner[point]].append(point)
        self.mesh, self.frame = mesh, None
        self.state_chunks.clear()

    def take_state(self, message, header):
        if not self.mesh or self.mesh["id"] != header["topology_id"]:
            return  # the mesh of this frame arrives within a second
        if self.frame and header["sequence"] <= self.frame["sequence"]:
            return
        for old in [k for k in self.state_chunks if k < header["sequence"]]:
            del self.state_chunks[old]
        chunks = self.state_chunks.setdefault(header["sequence"], {})
        chunks[message["chunk"]] = message
        if len(chunks) == message["chunks"]:
            self.frame = self.put_together([chunks[k] for k in sorted(chunks)], header)
            self.frames += 1

    def put_together(self, chunks, header):
        mesh = self.mesh
        x, y, scalar = list(mesh["start_x"]), list(mesh["start_y"]), []
        loose, moved = set(range(mesh["points"])), []
        for c in chunks:
            scalar += c["scalar"]
            for i, body in enumerate(c["body"]):  # x = start + u + (D - 1) (start - start of the first point)
                points = mesh["points_of"][body]
                x0, y0 = mesh["start_x"][points[0]], mesh["start_y"][points[0]]
                for p in points:
                    dx, dy = mesh["start_x"][p] - x0, mesh["start_y"][p] - y0
                    x[p] += c["ux"][i] + c["xx"][i] * dx + c["xy"][i] * dy
                    y[p] += c["uy"][i] + c["yx"][i] * dx + c["yy"][i] * dy
                    loose.discard(p)
            moved += [(c["base"][0] + c["scale"] * dx, c["base"][1] + c["scale"] * dy)
                      for dx, dy in zip(c["dx"], c["dy"])]
        for p, (dx, dy) in zip(sorted(loose), moved):
            x[p] += dx
            y[p] += dy
        return {"sequence": header["sequence"], "step": header["step"], "time": header["time"], "x": x, "y": y,
                "scalar": scalar}


# --- the network --------------------------------------------------------------------------------------------------------


def listen(group, port):
    s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    s.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    s.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
    s.bind((group, port))
    s.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton(group) + socket.inet_aton("0.0.0.0"))
    return s


def take_apart(datagram):
    """Channel and data of an LCM datagram, which consists of "LC02", the number of the message, the channel terminated
    by a zero byte, and the data. (LCM splits messages above 64 kB into fragments, "LC03"; those of Scree are smaller.)"""
    if datagram[:4] != b"LC02" or b"\0" not in datagram[8:72]:
        return None, None
    end = datagram.index(b"\0", 8)
    return datagram[8:end].decode(errors="replace"), datagram[end + 1:]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--run", default="", help="name of the run (default: the one that started last)")
    parser.add_argument("--group", default="239.255.76.67:7667")
    parser.add_argument("--for", dest="seconds", type=float, default=float("inf"), help="end after this many seconds")
    parser.add_argument("--timeout", type=float, default=10.0, help="give up after this many seconds without a message")
    parser.add_argument("--state", help="write the last frame, the monitors and the energy ledger to this file (JSON)")
    here = pathlib.Path(__file__).resolve().parent  # in the source tree, or in PREFIX/share/doc/scree/examples
    places = [here / "../../io/lcmtypes", here / "../../../scree/lcmtypes", pathlib.Path("/usr/share/scree/lcmtypes")]
    parser.add_argument("--types", default=next((p for p in places if any(p.glob("*.lcm"))), places[0]))
    arguments = parser.parse_args()
    run = Run(Decoder(read_types(arguments.types)))
    name = re.escape(arguments.run) if arguments.run else "[A-Za-z0-9_-]+"
    wanted = re.compile(rf"SCREE_{name}_(INFO|TOPO|STATE|HIST|ENERGY|EVENT)")
    group, port = arguments.group.split(":")
    source = listen(group, int(port))
    begin = heard = time.monotonic()
    told = set()
    while time.monotonic() - begin < arguments.seconds:
        source.settimeout(0.2)
        try:
            channel, data = take_apart(source.recv(65536))
        except socket.timeout:
            if time.monotonic() - heard > arguments.timeout:
                print(f"no message was received for {arguments.timeout:g} s", file=sys.stderr)
                return 5
            continue
        match = channel and wanted.fullmatch(channel)
        if not match or not run.take(match[1], data):
            continue
        heard = time.monotonic()
        for number in sorted(set(run.events) - told):
            told.add(number)
            event = run.events[number]
            print(f"{event['header']['time']:10.4f} s  {event['kind']}: {event['text']}", flush=True)
        if match[1] == "INFO":
            i = run.info
            print(f"{i['header']['time']:10.4f} s  {i['run']}: {i['status']}, {i['stage_name']}, {i['steps']} steps, "
                  f"{i['contacts']} contacts, {run.frames} frames", flush=True)
            if i["status"] not in ("running", "paused"):
                break
    if arguments.state:
        state = {"run": run.info and run.info["run"], "status": run.info and run.info["status"], "frame": run.frame,
                 "monitors": run.history, "frames": run.frames, "malformed": run.malformed, "events": len(run.events),
                 "energy": run.energy and dict(zip(run.energy["name"], run.energy["value"]))}
        pathlib.Path(arguments.state).write_text(json.dumps(state))
    return 0 if run.info else 5


if __name__ == "__main__":
    sys.exit(main())
