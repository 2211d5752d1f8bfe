"""Messages of Scree made by hand, for tests: encoder to the decoder of docs/examples/read_live.py, and the network."""
import pathlib
import socket
import struct
import sys
import time
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "docs" / "examples"))
import read_live  # noqa: E402

GROUP, PORT = "239.255.76.67", 7667
TYPES = read_live.read_types(ROOT / "io" / "lcmtypes")
DECODER = read_live.Decoder(TYPES)


def body(name, values):
    out = b""
    for field in TYPES[name]:
        value = values[field.name] if field.name != "crc" else 0
        for item in value if field.sizes else [value]:
            if field.type in read_live.NUMBERS:
                out += struct.pack(">" + read_live.NUMBERS[field.type], item)
            elif field.type == "string":
                text = item.encode() + b"\0"
                out += struct.pack(">i", len(text)) + text
            else:
                out += body(field.type, item)
    return out


def seal(data):
    """The message with the correct CRC at its end."""
    return data[:-4] + struct.pack(">I", zlib.crc32(data[:-4]))


def encode(name, values):
    return seal(DECODER.fingerprints[name] + body(name, values))


def header(session, sequence, **more):
    return {"utime": int(time.time() * 1e6), "session": session, "topology_id": -1, "sequence": sequence, "step": 0,
            "stage": 0, "time": 0.0, **more}


def command(session, sequence, text, value=0.0, sender=77):
    return encode("ctrl_v1_t", {"header": header(session, sequence), "sender": sender, "command": text, "value": value})


def datagram(channel, data, number=1):
    return b"LC02" + struct.pack(">I", number) + channel.encode() + b"\0" + data


def sender():
    out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
    return lambda data: out.sendto(data, (GROUP, PORT))


def messages(source, kinds, seconds):
    """Yields (channel, kind, data) of messages of these kinds during the given time."""
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        source.settimeout(left)
        try:
            channel, data = read_live.take_apart(source.recv(65536))
        except socket.timeout:
            return
        kind = channel.rsplit("_", 1)[-1] if channel else None
        if kind in kinds:
            yield channel, kind, data


class Asker:
    """Sends commands to a run and collects its answers."""

    def __init__(self, run):
        self.run, self.source, self.send = run, read_live.listen(GROUP, PORT), sender()
        self.sequence = 0

    def next_sequence(self):
        self.sequence = max(self.sequence + 1, int(time.time() * 1e6))
        return self.sequence

    def raw(self, data):
        self.send(datagram(f"SCREE_{self.run}_CTRL", data))

    def answers(self, seconds):
        return [DECODER.message("ack_v1_t", data)
                for channel, _, data in messages(self.source, {"ACK"}, seconds) if channel == f"SCREE_{self.run}_ACK"]

    def session(self, seconds=5.0):
        """Session of the run, as soon as it answers."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.raw(command(0, self.next_sequence(), "who"))
            for answer in self.answers(0.3):
                return answer["header"]["session"]
        raise SystemExit(f"{self.run} does not answer")
