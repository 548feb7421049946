"""Shows a layer of an EXR file as PNG. Reads what Lambert writes: scan lines, half and float channels, ZIP or no compression."""
import struct
import zlib


def read_exr(path):
    """Width, height and the channels by name, each a list of numbers."""
    data = path.read_bytes()
    at, header = 8, {}
    while data[at]:
        name, kind, rest = data[at:].split(b"\0", 2)[0], data[at:].split(b"\0", 2)[1], None
        at += len(name) + len(kind) + 2
        size = struct.unpack_from("<i", data, at)[0]
        header[name.decode()] = data[at + 4:at + 4 + size]
        at += 4 + size
    channels, c = [], header["channels"]
    while c[0]:
        name, c = c.split(b"\0", 1)
        channels.append((name.decode(), struct.unpack_from("<i", c)[0]))
        c = c[16:]
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    lines = {0: 1, 2: 1, 3: 16}[header["compression"][0]]
    kinds = {0: ("I", 4), 1: ("e", 2), 2: ("f", 4)}
    pixels = {name: [] for name, _ in channels}
    offsets = struct.unpack_from(f"<{-(-height // lines)}Q", data, at + 1)
    for block, offset in enumerate(offsets):
        size = struct.unpack_from("<i", data, offset + 4)[0]
        rows = min(lines, height - block * lines)
        expected = rows * width * sum(kinds[k][1] for _, k in channels)
        raw = data[offset + 8:offset + 8 + size]
        if size < expected:
            raw = unpack(raw)
        p = 0
        for _ in range(rows):
            for name, kind in channels:
                code, bytes_each = kinds[kind]
                pixels[name] += struct.unpack_from(f"<{width}{code}", raw, p)
                p += width * bytes_each
    return width, height, pixels


def unpack(data):
    """ZIP of differences of bytes, the even ones before the odd ones."""
    d = bytearray(zlib.decompress(data))
    for i in range(1, len(d)):
        d[i] = (d[i] + d[i - 1] - 128) & 255
    half = (len(d) + 1) // 2
    out = bytearray(len(d))
    out[0::2], out[1::2] = d[:half], d[half:]
    return bytes(out)


def srgb(x):
    x = min(max(x, 0), 1)
    return round(255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055))


def show(exr, layer, png):
    width, height, c = read_exr(exr)
    if layer == "depth":
        seen = [z for z in c["Z"] if z > 0]
        near, far = min(seen), sorted(seen)[int(len(seen) * 0.98)]
        pixels = [[round(255 * min(max(1 - (z - near) / (far - near), 0), 1)) if z > 0 else 0] * 3 for z in c["Z"]]
    elif layer == "normal":
        pixels = [[round(127.5 * (min(max(v, -1), 1) + 1)) for v in n] for n in zip(c["normal.X"], c["normal.Y"], c["normal.Z"])]
    else:
        pixels = [[srgb(v) for v in rgb] for rgb in zip(*(c[f"{layer}.{k}"] for k in "RGB"))]
    rows = b"".join(b"\0" + bytes(v for p in pixels[y * width:(y + 1) * width] for v in p) for y in range(height))

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    png.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                    chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
