"""Reads pictures that vestige-cli wrote."""
import struct
import zlib


def picture(path):
    """Width, height and rows of (r, g, b) of an 8-bit PNG without interlacing."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    channels = {2: 3, 6: 4}[kind]
    assert depth == 8
    packed, place = b"", 8
    while place < len(data):
        length, name = struct.unpack(">I4s", data[place:place + 8])
        if name == b"IDAT":
            packed += data[place + 8:place + 8 + length]
        place += 12 + length
    raw, stride, rows = zlib.decompress(packed), width * channels, []
    last = bytearray(stride)
    for y in range(height):
        filter_kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a = row[i - channels] if i >= channels else 0
            b, c = last[i], last[i - channels] if i >= channels else 0
            near = min((a, b, c), key=lambda one: abs(a + b - c - one))
            row[i] = (row[i] + (0, a, b, (a + b) // 2, near)[filter_kind]) & 255
        rows.append([tuple(row[x * channels:x * channels + 3]) for x in range(width)])
        last = row
    return width, height, rows
