#!/usr/bin/env python3
"""Sends malformed datagrams to the group while a run and a viewer listen: flood.py COUNT RUN SEED.

Made from messages heard just before: cut short, with forged lengths under a right CRC, wrong fingerprints, replayed
chunks, forged fragments of LCM, channels without an end, random bytes. Prints how many of each kind."""
import collections
import random
import struct
import sys
import time

from lcm_messages import DECODER, GROUP, PORT, command, datagram, messages, read_live, seal, sender

LENGTHS = (0x7FFFFFFF, 0x40000000, 0x20000001, 0xFFFFFFFF, 0x80000000, 0, 1, 100000)


def main():
    count, run, seed = int(sys.argv[1]), sys.argv[2], int(sys.argv[3])
    rng = random.Random(seed)
    source = read_live.listen(GROUP, PORT)
    kinds = ("INFO", "TOPO", "STATE", "HIST", "ENERGY", "EVENT", "ACK")
    heard = collections.defaultdict(list)
    for channel, kind, data in messages(source, set(kinds), 4.0):
        if channel.startswith(f"SCREE_{run}_") and len(heard[kind]) < 20:
            heard[kind].append(data)
        if all(heard[k] for k in kinds if k != "ACK") and len(heard["STATE"]) >= 5:
            break
    missing = [k for k in kinds if k != "ACK" and not heard[k]]
    if missing:
        raise SystemExit(f"never heard {missing}")
    session = DECODER.message("info_v1_t", heard["INFO"][0])["header"]["session"]
    # Commands of an ended session: valid ones would stop the run.
    heard["CTRL"] = [command(session - 1, int(time.time() * 1e6), text, 1.0) for text in ("stop", "pause", "step")]
    source.close()
    send, sent = sender(), collections.Counter()
    pool = [(kind, data) for kind, list_ in heard.items() for data in list_]

    def channel_of(kind):
        return f"SCREE_{run}_{kind}"

    def truncated(kind, data):
        return datagram(channel_of(kind), data[:rng.randrange(len(data))])

    def truncated_sealed(kind, data):
        return datagram(channel_of(kind), seal(data[:rng.randrange(12, len(data))]))

    def forged_length(kind, data):
        at = rng.randrange(8, max(9, min(len(data) - 8, 600)))
        return datagram(channel_of(kind), seal(data[:at] + struct.pack(">I", rng.choice(LENGTHS)) + data[at + 4:]))

    def wrong_fingerprint(kind, data):
        return datagram(channel_of(kind), seal(rng.randbytes(8) + data[8:]))

    def other_kind(kind, data):
        return datagram(channel_of(rng.choice([k for k in kinds if k != kind])), data)

    def replayed_chunk(kind, data):
        # Valid but repeated: topology and state sent some time ago.
        again = rng.choice(("TOPO", "STATE"))
        return datagram(channel_of(again), rng.choice(heard[again]))

    def changed_bytes(kind, data):
        bad = bytearray(data)
        for _ in range(rng.randrange(1, 6)):
            bad[rng.randrange(len(bad))] = rng.randrange(256)
        return datagram(channel_of(kind), bytes(bad))

    def forged_fragment(kind, data):
        # Two fragments that crash a program that receives by liblcm: an offset beyond the message, a fragment without a first one.
        size, offset = rng.choice(LENGTHS), rng.choice(LENGTHS)
        number, pieces = rng.choice((0, 1, 2, 65535)), rng.choice((0, 1, 2, 65535))
        name = channel_of(kind).encode() + b"\0" if number == 0 else b""
        return struct.pack(">4sIIIHH", b"LC03", rng.randrange(4), size, offset, number, pieces) + name + data[:1000]

    def endless_channel(kind, data):
        return b"LC02\0\0\0\1" + channel_of(kind).encode() + bytes(rng.randrange(1, 256) for _ in range(rng.randrange(80)))

    def noise(kind, data):
        return rng.choice((b"", b"LC02", b"LC03", b"LC02\0\0\0\1")) + rng.randbytes(rng.randrange(200))

    makers = (truncated, truncated_sealed, forged_length, forged_length, wrong_fingerprint, other_kind, replayed_chunk,
              changed_bytes, forged_fragment, forged_fragment, endless_channel, noise)
    for i in range(count):
        make = rng.choice(makers)
        try:
            send(make(*rng.choice(pool)))
            sent[make.__name__] += 1
        except OSError as error:
            raise SystemExit(f"datagram {i}: {error}")
        # At the rate that a receiver under the address sanitizer can process; datagrams dropped by the system test nothing.
        if i % 20 == 19:
            time.sleep(0.004)
    print(", ".join(f"{n} {name}" for name, n in sorted(sent.items())))


main()
