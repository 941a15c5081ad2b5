#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""run_oled.py PROGRAM.elf FOLDER

Runs platform/lm3s_oled on QEMU's lm3s6965evb and writes what the display shows after each frame, FOLDER/frame-0.raw, ...,
as the OLED's own bytes (two pixels a byte). Prints the program's lines; ends as the program does.
"""
import os
import socket
import subprocess
import sys

WIDTH, HEIGHT = 128, 64


def ask(monitor, command):
    """Sends a command to QEMU's monitor and waits until it is done."""
    monitor.sendall(command.encode() + b"\n")
    reply = b""
    while not reply.endswith(b"(qemu) "):
        part = monitor.recv(4096)
        if not part:
            sys.exit("QEMU's monitor has closed")
        reply += part


def pixels_of(path):
    """The display's bytes from QEMU's picture, which shows a pixel as a square and a grey as one of 16 colours."""
    data = open(path, "rb").read()
    kind, size, _, rgb = data.split(b"\n", 3)
    width, height = (int(side) for side in size.split())
    if kind != b"P6" or width % WIDTH or width * HEIGHT != height * WIDTH:
        sys.exit(f"{path}: {width} x {height} pixels are no picture of the display")
    side = width // WIDTH
    greys = [rgb[((y * side + side // 2) * width + x * side + side // 2) * 3] >> 4 for y in range(HEIGHT) for x in range(WIDTH)]
    return bytes(greys[k] << 4 | greys[k + 1] for k in range(0, len(greys), 2))


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, folder = sys.argv[1:]
    path = os.path.join(folder, "monitor")
    if os.path.exists(path):
        os.remove(path)
    listener = socket.socket(socket.AF_UNIX)
    here = os.getcwd()
    os.chdir(folder)  # names of sockets are short
    listener.bind("monitor")
    os.chdir(here)
    listener.listen(1)
    command = ["qemu-system-arm", "-M", "lm3s6965evb", "-display", "none", "-icount", "shift=0", "-serial", "stdio",
               "-monitor", "unix:monitor", "-kernel", os.path.abspath(program)]
    emulator = subprocess.Popen(command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    monitor, _ = listener.accept()
    reply = b""
    while not reply.endswith(b"(qemu) "):
        reply += monitor.recv(4096)
    code = 1
    for line in emulator.stdout:
        words = line.decode().split()
        if words[0] == "exit":
            code = int(words[1])
            break
        print(" ".join(words))
        ask(monitor, "screendump screen.ppm")
        with open(os.path.join(folder, f"frame-{words[1]}.raw"), "wb") as file:
            file.write(pixels_of(os.path.join(folder, "screen.ppm")))
        emulator.stdin.write(b"\n")
        emulator.stdin.flush()
    monitor.sendall(b"quit\n")
    emulator.wait()
    os.remove(path)
    sys.exit(code)


if __name__ == "__main__":
    main()
