#!/usr/bin/env python3
"""Counts the messages of an LCM log and checks what is needed: live_log.py LOG --need KIND... --largest BYTES
--longest-gap KIND SECONDS."""
import argparse
import collections
import re
import struct
import sys

SYNC = 0xEDA1DA01
HEADER = struct.Struct(">IqqII")  # sync word, event number, time [us], length of the channel name, length of the data


def events(path):
    """Yields (channel, time [s], data) of each event."""
    with open(path, "rb") as log:
        while header := log.read(HEADER.size):
            sync, _, utime, name, size = HEADER.unpack(header)
            if sync != SYNC:
                raise ValueError(f"byte {log.tell() - HEADER.size}: no event begins here")
            channel, data = log.read(name), log.read(size)
            if len(channel) != name or len(data) != size:
                raise ValueError("the last event is cut off")
            yield channel.decode("ascii"), utime * 1e-6, data


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("log")
    parser.add_argument("--need", nargs="+", default=[])
    parser.add_argument("--largest", type=int, default=60000)
    parser.add_argument("--longest-gap", nargs=2, metavar=("KIND", "SECONDS"), action="append", default=[])
    arguments = parser.parse_args()
    count, largest, wrong = collections.Counter(), 0, []
    times, end = collections.defaultdict(list), 0.0
    for channel, time, data in events(arguments.log):
        if channel == "LCM_SELF_TEST":
            continue
        match = re.fullmatch(r"SCREE_[A-Za-z0-9_-]+_([A-Z]+)", channel)
        if not match or len(channel) > 63:
            wrong.append(f"channel {channel!r}")
            continue
        count[match[1]] += 1
        times[match[1]].append(time)
        end = max(end, time)
        largest = max(largest, len(data))
    wrong += [f"no {kind} message" for kind in arguments.need if not count[kind]]
    if largest > arguments.largest:
        wrong.append(f"a message of {largest} bytes")
    for kind, most in arguments.longest_gap:
        gap = max((b - a for a, b in zip(times[kind], times[kind][1:] + [end])), default=float("inf"))
        print(f"longest time between two {kind} messages: {gap:.2f} s")
        if gap > float(most):
            wrong.append(f"{gap:.2f} s without a {kind} message")
    print(", ".join(f"{n} {kind}" for kind, n in sorted(count.items())) or "empty log", f"largest {largest} bytes")
    for text in wrong:
        print(text)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
