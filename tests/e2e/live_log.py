#!/usr/bin/env python3
"""Counts the messages of an LCM log and checks what is needed: live_log.py LOG --need KIND... --largest BYTES."""
import argparse
import collections
import re
import struct
import sys

SYNC = 0xEDA1DA01
HEADER = struct.Struct(">IqqII")  # sync word, event number, time [us], length of the channel name, length of the data


def events(path):
    """Yields (channel, data) of each event."""
    with open(path, "rb") as log:
        while header := log.read(HEADER.size):
            sync, _, _, name, size = HEADER.unpack(header)
            if sync != SYNC:
                raise ValueError(f"byte {log.tell() - HEADER.size}: no event begins here")
            channel, data = log.read(name), log.read(size)
            if len(channel) != name or len(data) != size:
                raise ValueError("the last event is cut off")
            yield channel.decode("ascii"), data


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("log")
    parser.add_argument("--need", nargs="+", default=[])
    parser.add_argument("--largest", type=int, default=60000)
    arguments = parser.parse_args()
    count, largest, wrong = collections.Counter(), 0, []
    for channel, data in events(arguments.log):
        if channel == "LCM_SELF_TEST":
            continue
        match = re.fullmatch(r"SCREE_[A-Za-z0-9_-]+_([A-Z]+)", channel)
        if not match or len(channel) > 63:
            wrong.append(f"channel {channel!r}")
            continue
        count[match[1]] += 1
        largest = max(largest, len(data))
    wrong += [f"no {kind} message" for kind in arguments.need if not count[kind]]
    if largest > arguments.largest:
        wrong.append(f"a message of {largest} bytes")
    print(", ".join(f"{n} {kind}" for kind, n in sorted(count.items())) or "empty log", f"largest {largest} bytes")
    for text in wrong:
        print(text)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
