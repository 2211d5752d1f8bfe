#!/usr/bin/env python3
"""Commands that a run must refuse: of another session, replayed, malformed, dated ahead, too frequent.
usage: forged_commands.py RUN"""
import sys

from lcm_messages import Asker, command, seal


def main():
    asker = Asker(sys.argv[1])
    session = asker.session()
    wrong = []

    def expect(what, data, result, reason=""):
        asker.raw(data)
        got = [(a["result"], a["reason"]) for a in asker.answers(0.4)]
        fits = not got if result is None else any(r == result and reason in text for r, text in got)
        if not fits:
            wrong.append(f"{what}: {got or 'no answer'} instead of {result} {reason}")

    first = command(session, asker.next_sequence(), "rate", 20.0)
    expect("a good one", first, "done")
    expect("it again", first, "done")  # answered again, not executed again
    expect("an old number", command(session, asker.sequence - 11 * 10**6, "stop"), "refused", "behind")
    for ahead in (59, 3):
        expect("dated ahead", command(session, asker.next_sequence() + ahead * 10**6, "stop", sender=78), "refused", "ahead")
    asker.raw(command(session, asker.next_sequence() + 19 * 10**5, "rate", 20.0, sender=78))  # just inside the window
    expect("a good one after one dated ahead", command(session, asker.next_sequence(), "rate", 21.0), "done")
    expect("another session", command(session - 1, asker.next_sequence(), "stop"), "refused", "session")
    expect("a later session", command(session + 1, asker.next_sequence(), "stop"), "refused", "session")
    expect("dated ahead", command(session, asker.next_sequence() + 10**9, "stop"), "refused", "ahead")
    expect("an unknown command", command(session, asker.next_sequence(), "explode"), None)
    expect("no steps", command(session, asker.next_sequence(), "step", 0.0), "refused", "whole number")
    expect("half a step", command(session, asker.next_sequence(), "step", 0.5), "refused", "whole number")
    expect("no number of steps", command(session, asker.next_sequence(), "step", float("nan")), "refused", "whole number")
    good = command(session, asker.next_sequence(), "stop")
    expect("a wrong CRC", good[:-1] + bytes([good[-1] ^ 1]), None)
    expect("cut short", good[:40], None)
    expect("too long", seal(good + b"\0\0\0\0"), None)
    expect("another fingerprint", seal(b"\x01" + good[1:]), None)
    length = 8 + 5 * 8 + 4 + 8 + 8  # position of the length of the text
    for size in (0, -1, 2**31 - 1, 10**6):
        expect(f"a text of {size} bytes", seal(good[:length] + (size & 0xFFFFFFFF).to_bytes(4, "big") + good[length + 4:]),
               None)
    many = [command(session, asker.next_sequence(), "rate", 20.0) for _ in range(200)]
    for data in many:
        asker.raw(data)
    results = [a["result"] for a in asker.answers(1.5)]
    done, refused = results.count("done"), results.count("refused")
    if not 1 <= done <= 60 or not 1 <= refused <= 60:
        wrong.append(f"of 200 at once {done} were carried out and {refused} refused")
    print(f"of 200 commands at once {done} were carried out, {refused} refusals were told")
    expect("a good one after all that", command(session, asker.next_sequence(), "rate", 30.0), "done")
    for text in wrong:
        print(text)
    return 1 if wrong else 0


sys.exit(main())
