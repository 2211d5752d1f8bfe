#!/usr/bin/env python3
"""Runs a command on a terminal of its own, 110 x 70, and prints the text left on it at the end: terminal.py COMMAND...

For `scree watch` that is the last screen, since it leaves the alternate one that it draws on. Its exit code is passed on."""
import fcntl
import os
import pty
import signal
import struct
import sys
import termios


def main():
    child, terminal = pty.fork()
    if child == 0:
        os.execvp(sys.argv[1], sys.argv[1:])
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 70, 110, 0, 0))
    signal.signal(signal.SIGTERM, lambda *_: os.kill(child, signal.SIGTERM))
    text = b""
    while True:
        try:
            got = os.read(terminal, 65536)
        except OSError:  # the other end is closed
            break
        if not got:
            break
        text = (text + got)[-1000000:]
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    sys.stdout.buffer.write(text.split(b"\033[?1049l")[-1].replace(b"\r\n", b"\n"))
    return code if code >= 0 else 128 - code


sys.exit(main())
