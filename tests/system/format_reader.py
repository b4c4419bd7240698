#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A decoder of .mcpr files written from FORMAT.md alone, to show that the page is enough.

Slow and without limits: for tests only. Names and numbers of sections are FORMAT.md's; the tables
of its appendix are read from it.

Usage: format_reader.py FORMAT.md CLIP.mcpr EXPECTED.f32|EXPECTED.csv [--positions|--tracks]
       compares the channels with 32-bit floats, frame after frame (equal to the bit), or with the
       rows of a .csv (equal to 1e-4); or the joints' places in the world (equal to 1e-4); or the
       values of scalar tracks (equal to the bit)
"""
import math
import re
import struct
import sys
import zlib

ROOT_OF_HALF = float.fromhex("0x1.6a09e667f3bcdp-1")
ROOT_OF_HALF_32 = float.fromhex("0x1.6a09e6p-1")


def f32(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def clamp(value, least, most):
    return max(least, min(value, most))


def digits(value):
    return value.bit_length()


def over(a, b):
    """Integers, rounded towards zero."""
    return a // b if (a >= 0) == (b > 0) else -(-a // b)


def refuse(what):
    raise ValueError(what)


class Tables:
    """The appendix."""

    def __init__(self, page):
        def block(title):
            return re.search(title + r"\n.*?\n```\n(.*?)\n```", page, re.S).group(1)

        def rows(title):
            return [[int(number) for number in line.split()] for line in block(title).splitlines()]

        self.scale_weights = rows(r"### A\.1 [^\n]*")
        def letters(title):
            return "".join(line[1:-1] for line in block(title).splitlines())

        self.letters = letters(r"### A\.2 [^\n]*")
        self.trust = letters(r"### A\.3 [^\n]*")
        self.weights = rows(r"### A\.4 [^\n]*")


class Cursor:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, size):
        if self.at + size > len(self.data):
            refuse("ends early")
        self.at += size
        return self.data[self.at - size : self.at]

    def read(self, form):
        values = struct.unpack("<" + form, self.take(struct.calcsize("<" + form)))
        return values[0] if len(values) == 1 else values

    def rest(self):
        return self.take(len(self.data) - self.at)


# ---------------------------------------------------------------- 6.1, 6.2


class RangeDecoder:
    def __init__(self, data):
        self.data, self.at, self.low, self.high, self.code = data, 0, 0, 2**32 - 1, 0
        for _ in range(4):
            self.shift_in()

    def shift_in(self):
        byte = self.data[self.at] if self.at < len(self.data) else 0
        self.code = (self.code << 8 | byte) & 0xFFFFFFFF
        self.at += 1

    def bit(self, one):
        if self.at > len(self.data) + 4:
            refuse("coded bits end early")
        middle = self.low + ((self.high - self.low) * one >> 16)
        bit = self.code <= middle
        if bit:
            self.high = middle
        else:
            self.low = middle + 1
        while self.low >> 24 == self.high >> 24:
            self.low = self.low << 8 & 0xFFFFFFFF
            self.high = (self.high << 8 | 255) & 0xFFFFFFFF
            self.shift_in()
        return bit

    def expect_end(self):
        if not len(self.data) <= self.at <= len(self.data) + 4:
            refuse("coded bits end early or late")


SQUASHED = [round(65536 / (1 + math.exp(8 - i / 2))) for i in range(33)]


def squash(x):
    x = clamp(x, -2047, 2047) + 2048
    i, r = x >> 7, x & 127
    return (SQUASHED[i] * (128 - r) + SQUASHED[i + 1] * r + 64) >> 7


def stretch_table():
    table, x = [], -2047
    for q in range(4096):
        while x < 2047 and squash(x) < 16 * q + 8:
            x += 1
        table.append(x)
    return table


STRETCHED = stretch_table()


class Context:
    __slots__ = ("one", "seen")

    def __init__(self, one=32768, seen=0):
        self.one, self.seen = one, seen

    def follow(self, bit):
        self.one += ((65535 if bit else 0) - self.one) * (131072 // (2 * self.seen + 3)) >> 16
        self.seen = min(self.seen + 1, 250)


def bit_in_one(bits, context):
    bit = bits.bit(clamp(context.one, 64, 65472))
    context.follow(bit)
    return bit


def bit_in_several(bits, contexts, weights, opinions=(), slowness=17):
    evidence = [STRETCHED[context.one >> 4] for context in contexts] + list(opinions)
    p = squash(sum(w * e for w, e in zip(weights, evidence)) >> 16)
    bit = bits.bit(p)
    for i, e in enumerate(evidence):
        change = (((65536 if bit else 0) - p) * e * 3 + (1 << slowness - 1)) >> slowness
        weights[i] = clamp(weights[i] + change, -(2**22), 2**22)
    for context in contexts:
        context.follow(bit)
    return bit


# ---------------------------------------------------------------- 4, JNTS


class Joint:
    pass


def decode_joint_bytes(bits, size, fields=None):
    contexts = [{} for _ in range(5)]
    weights = [[26214] * 5 for _ in range(19)]
    data = bytearray()
    for field in (fields or joint_fields)(data):
        if len(data) == size:
            break
        b1, b2, b3 = (data[-n] if len(data) >= n else 0 for n in (1, 2, 3))
        keys = (
            field,
            field | b1 << 8,
            field | b1 << 8 | b2 << 16,
            b1 | b2 << 8 | b3 << 16,
            field | b1 << 8 | b2 << 16 | b3 << 24,
        )
        node = 1
        while node < 256:
            chosen = []
            for order, key in enumerate(keys):
                mixed = (key * 0x9E3779B1 ^ node * 0x85EBCA6B) & 0xFFFFFFFF
                slot = (mixed * 0xC2B2AE35 & 0xFFFFFFFF) >> 18
                chosen.append(contexts[order].setdefault(slot, Context()))
            node = 2 * node + bit_in_several(bits, chosen, weights[field])
        data.append(node - 256)
    return bytes(data)


def joint_fields(data):
    """The field of each next byte; `data` grows in between."""
    while True:
        yield 0
        for _ in range(data[-1]):
            yield 1
        yield from (2, 3)
        yield from (4, 5, 6, 7) * 3
        yield 8
        flags = data[-1]
        yield from (9, 10, 11, 12) * (4 * (flags & 1))
        yield from (13, 14, 15, 16) * (3 * (flags >> 1 & 1))
        yield 17
        for _ in range(data[-1]):
            yield 18


def read_joints(payload):
    head = Cursor(payload)
    size, count, channels = head.read("IHH")
    bits = RangeDecoder(head.rest())
    cursor = Cursor(decode_joint_bytes(bits, size))
    bits.expect_end()
    joints = []
    for index in range(count):
        joint = Joint()
        joint.name = cursor.take(cursor.read("B")).decode()
        joint.parent = cursor.read("h")
        if not -1 <= joint.parent < index:
            refuse("a parent after its child")
        joint.offset = cursor.read("fff")
        flags = cursor.read("B")
        joint.axes = IDENTITY
        if flags & 1:
            quaternion = cursor.read("ffff")
            length = math.sqrt(sum(q * q for q in quaternion))
            joint.axes = rotation_of([q / length for q in quaternion])
        joint.end_site = cursor.read("fff") if flags & 2 else (0, 0, 0)
        joint.kinds = list(cursor.take(cursor.read("B")))
        joint.before = joint.after = IDENTITY
        joint.first_channel = sum(len(other.kinds) for other in joints)
        joints.append(joint)
    if cursor.rest() or sum(len(joint.kinds) for joint in joints) != channels:
        refuse("another skeleton than was promised")
    return joints


# ---------------------------------------------------------------- 7, bands


class Bands:
    def __init__(self, length):
        self.bands = []
        while length >= 4:
            self.bands.insert(0, ((length + 1) // 2, length // 2))
            length = (length + 1) // 2
        self.bands.insert(0, (0, length))
        self.count = len(self.bands)

    def first(self, b):
        return self.bands[b][0]

    def size(self, b):
        return self.bands[b][1]

    def depth(self, b):
        return 0 if self.count == 1 else self.count - max(b, 1)


# ---------------------------------------------------------------- 6.3 .. 6.8

SHARED = [
    ("zero_near", 8, 8, 8), ("zero_crowd", 10, 8, 8), ("zero_expected", 8, 32),
    ("class_recent", 8, 10, 10), ("class_expected", 8, 32), ("top_expected", 8, 32),
    ("top_recent", 8, 10, 8), ("next_digit", 8, 2, 8), ("sign_near", 8, 9, 3),
    ("sign_above", 9, 3, 2), ("significant_level", 8, 10), ("significant_neighbours", 3, 3, 10),
    ("significant_length", 8, 8, 10), ("number_plain", 6, 32), ("number_first", 6, 16, 16),
    ("number_second", 6, 16, 16), ("number_third", 6, 16, 16), ("number_top", 6, 32),
    ("number_fourth", 6, 32, 16),
]  # fmt: skip
OWN = [("zero_own", 8), ("class_own", 8), ("sign_neighbours", 3, 3), ("sign_before", 3, 3)]
INVERSE = [round(65536 / 2 ** ((q - 12) / 4)) for q in range(64)]
TAILS = [round(2**30 / (1 + math.exp(j / 4))) for j in range(65)]
SIZES = [0, 1, 2, 3, 3, 4, 4, 4, 5, 5, 5, 5, 5, 5, 6, 6]
TAPS = 24
REST_TAPS = 56


def neighbours(joints, effectors):
    """Sibling and mirror of every signal; -1: none."""
    children = [[] for _ in joints]
    for j, joint in enumerate(joints):
        if joint.parent >= 0:
            children[joint.parent].append(j)
    shapes = [None] * len(joints)
    for j in reversed(range(len(joints))):
        shapes[j] = (len(joints[j].kinds), tuple(shapes[k] for k in children[j]))
    mirrors = [-1] * len(joints)
    for p in range(len(joints)):
        for place, j in enumerate(children[p]):
            if mirrors[p] >= 0:
                others = children[mirrors[p]]
                if place < len(others) and others[place] < j:
                    mirrors[j] = others[place]
                continue
            for k in children[p][:place]:
                if shapes[k] == shapes[j] and mirrors[k] < 0:
                    mirrors[j] = k
    pairs, last_of = [], []
    for j, joint in enumerate(joints):
        last = last_of[joint.parent] if joint.parent >= 0 else -1
        for i in range(len(joint.kinds)):
            mirror = joints[mirrors[j]].first_channel + i if mirrors[j] >= 0 else -1
            pairs.append((last, mirror))
            last = len(pairs) - 1
        last_of.append(last)
    first = len(pairs)
    for s in range(3 * effectors):
        pairs.append((first + s - 1 if s % 3 else -1, first + s - 3 if s >= 3 else -1))
    return pairs


class Prediction:
    def __init__(self):
        self.weight = [0] * TAPS
        self.error = [0] * TAPS
        self.product = [[163840 if a == b else 0 for b in range(TAPS)] for a in range(TAPS)]
        self.seen = 0

    def of(self, taps):
        return clamp(sum(w * t for w, t in zip(self.weight, taps)) >> 14, -2046, 2046)

    def follow(self, taps, error):
        some = [n for n in range(TAPS) if taps[n]]
        if not some:
            return
        for m in some:
            for n in some:
                self.product[m][n] += taps[m] * taps[n]
            self.error[m] += taps[m] * error
        self.seen += 1
        if self.seen == 512:
            self.seen = 256
            self.product = [[value >> 1 for value in row] for row in self.product]
            self.error = [value >> 1 for value in self.error]
        for _ in range(3):
            m = max(range(TAPS), key=lambda n: (abs(self.error[n]), -n))
            d = clamp(over(self.error[m] << 14, max(self.product[m][m], 1)), -8192, 8192)
            d = clamp(self.weight[m] + d, -131072, 131072) - self.weight[m]
            if d == 0:
                continue
            self.weight[m] += d
            for n in range(TAPS):
                left = self.error[n] - (d * self.product[m][n] >> 14)
                self.error[n] = clamp(left, -(2**40), 2**40)


class Rest:
    def __init__(self):
        self.weight = [0] * REST_TAPS

    def of(self, taps):
        whole = 2048 + sum((w >> 8) * t for w, t in zip(self.weight, taps))
        return clamp(whole >> 12, -2046, 2046)

    def follow(self, taps, error):
        step = over(error * 121635, 37120 + sum(t * t for t in taps))
        self.weight = [clamp(w + step * t, -(2**22), 2**22) for w, t in zip(self.weight, taps)]


def tail(z):
    if z < 0:
        return 2**30 - tail(-z)
    j = z >> 6
    return TAILS[64] if j >= 64 else TAILS[j] - ((TAILS[j] - TAILS[j + 1]) * (z & 63) >> 6)


class Expected:
    def __init__(self, mean, deviation):
        self.mean, self.narrowness = mean, 1498112 // max(deviation, 16)

    def above(self, x, w):
        z = (64 * x - 32 - self.mean) * self.narrowness >> (10 - w)
        return tail(clamp(z, -4096, 4096))

    @staticmethod
    def opinion(part, whole):
        if whole < 256:
            return 0
        r = max(digits(whole) - 18, 0)
        return STRETCHED[min((part >> r) * 4096 // (whole >> r), 4095)]

    def some(self):
        return [
            self.opinion(self.above(1, w) + 2**30 - self.above(0, w), 2**30) for w in (0, 1)
        ]

    def minus(self):
        below = [2**30 - self.above(0, w) for w in (0, 1)]
        return [self.opinion(below[w], self.above(1, w) + below[w]) for w in (0, 1)]

    def range(self, a, b, c=None):
        end = [0 if c is None else self.above(c, w) for w in (0, 1)]
        return [
            self.opinion(self.above(b, w) - end[w], self.above(a, w) - end[w]) for w in (0, 1)
        ]


def size_of(total):
    return SIZES[total] if total < 16 else 6 if total < 40 else 7


def half_octave(v):
    return v if v < 2 else min(2 * digits(v) - 2 + (v >> (digits(v) - 2) & 1), 31)


def log2_256(v):
    mantissa = v >> (digits(v) - 9) if digits(v) > 9 else v << (9 - digits(v))
    return 256 * (digits(v) - 1) + (mantissa & 255)


def sign_of(v):
    return 2 if v > 0 else 1 if v < 0 else 0


def grouped_number(cursor):
    """Groups of 7 bits, the lowest first: 12, "Index"."""
    value = 0
    for shift in range(0, 63, 7):
        byte = cursor.read("B")
        value |= (byte & 127) << shift
        if byte < 128:
            return value
    return refuse("a number without an end")


class Stream:
    """Decodes the quantised values of a stream."""

    def __init__(self, data, length, pairs, tables, learned=None, left_out=0):
        cursor = Cursor(data)
        self.scale = struct.unpack("<f", struct.pack("<I", cursor.read("H") << 16))[0]
        if not (0 < self.scale < math.inf):
            refuse("no scale")
        self.bits = RangeDecoder(cursor.rest())
        self.pairs, self.bands = pairs, Bands(length)
        self.scale_weights = tables.scale_weights
        self.weights = [[64 * share for share in row] for row in tables.weights]
        self.tables = {}
        at = 0
        for name, *sizes in SHARED:
            self.tables[name] = (sizes, at)
            at += math.prod(sizes)
        self.contexts = [self.prior(*both) for both in zip(tables.letters, tables.trust)]
        if at != len(self.contexts):
            refuse("another number of letters")
        for name, *sizes in OWN:
            self.tables[name] = ([len(pairs)] + sizes, len(self.contexts))
            seldom = (6000, 1) if name == "zero_own" else (32768, 0)
            self.contexts += [Context(*seldom) for _ in range(len(pairs) * math.prod(sizes))]
        if learned:
            self.learn(Cursor(learned))
        self.exponents = []
        self.values = [[0] * length for _ in pairs]
        self.run(left_out)
        self.bits.expect_end()

    def learn(self, cursor):
        """The priors that a bank's clips taught: 12, "Packed clips"."""
        signals = cursor.read("H")
        for row in self.weights:
            for i in range(8):
                change = 2048 * cursor.read("b")
                if i < len(row):
                    row[i] += change
                elif change:
                    refuse("a change of a weight that is not there")
        shared = sum(math.prod(sizes) for _, *sizes in SHARED)
        known = len(self.contexts) if signals == len(self.pairs) else shared
        at = 0
        while cursor.at < len(cursor.data):
            at += grouped_number(cursor)
            code = cursor.read("B")
            if at < known:
                log_odds = 66 * (2 * (code % 32) - 31)
                seen = (3, 5, 8, 14, 26, 50, 100, 240)[code // 32]
                self.contexts[at] = Context(squash(log_odds), seen)
            at += 1

    @staticmethod
    def prior(letter, trust):
        if letter == " ":
            return Context()
        step = ord(letter) - 35 - (letter > "\\")
        seen = (3, 5, 8, 12, 18, 26, 40, 60, 90, 130, 180, 240)[ord(trust) - ord("a")]
        return Context(squash(over((step - 44) * 512, 11)), seen)

    def context(self, name, *places):
        sizes, at = self.tables[name]
        index = 0
        for place, size in zip(places, sizes):
            index = index * size + place
        for size in sizes[len(places) :]:
            index *= size
        return self.contexts[at + index]

    def mixed(self, weights, named, opinions=()):
        contexts = [self.context(*one) for one in named]
        return bit_in_several(self.bits, contexts, self.weights[weights], opinions, 18)

    def number(self, kind, a, b, c, d):
        n = 0
        while True:
            m = min(n, 15)
            if not self.mixed(
                19 + kind,
                [
                    ("number_plain", kind, n),
                    ("number_first", kind, a, m),
                    ("number_second", kind, b, m),
                    ("number_third", kind, c, m),
                    ("number_fourth", kind, d, m),
                ],
            ):
                break
            n += 1
            if n == 31:
                refuse("a number out of bounds")
        v = 1
        for d in range(n):
            top = d == 0
            v = 2 * v + (
                bit_in_one(self.bits, self.context("number_top", kind, n))
                if top
                else self.bits.bit(32768)
            )
        return v - 1

    def signed(self, kind, a, b, c, d):
        v = self.number(kind, a, b, c, d)
        return (v + 1) // 2 if v % 2 else -(v // 2)

    def run(self, left_out):
        self.read_exponents()
        for s in range(len(self.pairs)):
            self.read_coarse(s)
        self.restless_of = [0] * len(self.pairs)
        self.deviation = [26 + 2**24 // inverse for inverse in INVERSE]
        self.predictions = [Prediction() for _ in self.pairs]
        self.rests = [Rest() for _ in self.pairs]
        before = []
        for b in range(1, self.bands.count - left_out):
            size = self.bands.size(b) + 2
            # [i + 1]
            self.restless = [
                over(before[min((at + 1) // 2, len(before) - 1)], 2) if before else 0
                for at in range(size)
            ]
            before = self.restless
            self.activity = [0] * (self.bands.size(b) + 2)
            for s in range(len(self.pairs)):
                self.read_band(b, s)

    def read_exponents(self):
        before = 0
        for s, (sibling, mirror) in enumerate(self.pairs):
            model = mirror if mirror >= 0 else s - 1
            expected = self.exponents[model] if model >= 0 else 0
            before = self.signed(
                1 if mirror >= 0 else 0,
                1 if sibling == s - 1 else 0,
                min(abs(before), 15),
                8 + clamp(before, -7, 7),
                0,
            )
            self.exponents.append(expected + before)
            if not -128 <= self.exponents[-1] <= 127:
                refuse("a step exponent out of bounds")

    def read_coarse(self, s):
        sibling, mirror = self.pairs[s]

        def size(t, i):
            if t < 0:
                return 0
            change = self.values[t][i] - (self.values[t][i - 1] if i > 0 else 0)
            return min(1 + digits(abs(change)), 15)

        half_octaves = (struct.unpack("<I", struct.pack("<f", self.scale))[0] >> 22) - 254
        depth = self.exponents[s] + self.bands.depth(0) - half_octaves
        depth = clamp(over(depth, 2) + 6, 0, 31)
        for i in range(self.bands.size(0)):
            b = size(sibling, 0) if i == 0 else 0 if i == 1 else size(s, i - 1)
            kind = (2 if i == 0 else 3) + (2 if s < 3 else 0)
            change = self.signed(kind, size(mirror, i), b, size(s - 1, i), depth)
            self.values[s][i] = (self.values[s][i - 1] if i > 0 else 0) + change
            if abs(self.values[s][i]) > 2**28:
                refuse("a value out of bounds")

    def read_band(self, b, s):
        first, size = self.bands.bands[b]
        first_above, size_above = self.bands.bands[b - 1]
        level = min(self.bands.count - 1 - b, 7)
        sibling, mirror = self.pairs[s]

        def value(t, i):
            return self.values[t][first + i] if t >= 0 and 0 <= i < size else 0

        def parent(i):
            return self.values[s][first_above + i] if b > 1 and 0 <= i < size_above else 0

        if b > 1:
            total = sum(min(abs(parent(i)), 255) for i in range(size_above))
        else:
            total = size_above
        density = 0 if total == 0 else min(1 + digits(16 * total // size_above), 9)

        def state(t):
            return 2 if t < 0 else 1 if any(value(t, i) for i in range(size)) else 0

        if not self.mixed(
            0,
            [
                ("significant_level", level, density),
                ("significant_neighbours", state(sibling), state(mirror), density),
                ("significant_length", level, min(digits(size), 7), density),
            ],
        ):
            return
        activity, restless, recent = self.activity, self.restless, 0
        for i in range(size):
            own = [value(s, i - n) for n in (1, 2, 3)]
            k = i // 2
            around = (k + 1, k - 1) if i % 2 else (k - 1, k + 1)
            parents = [parent(k), parent(around[0]), parent(around[1])]
            size_own = size_of(2 * abs(own[0]) + abs(own[1]))
            size_parents = size_of(2 * abs(parents[0]) + abs(parents[1]))
            busy = 2 * activity[i + 1] + activity[i] + activity[i + 2]
            crowd = min(digits(8 * busy // s), 9) if s else 0
            degree = min(digits(over(recent, 4)), 9)
            near = own + parents[:2] + [value(sibling, i), value(mirror, i)]
            shares = (20, 5, 3, 7, 2, 7, 14)
            expected = half_octave(
                sum(share * min(abs(v), 255) for share, v in zip(shares, near))
                + (16 * activity[i + 1] // s if s else 0)
                + over(recent, 4)
            )
            # 6.8: scale, prediction, distribution
            beside = [value(t, j) for t in (sibling, mirror) for j in (i - 1, i, i + 1)]
            features = [64 * min(abs(v), 2**14) for v in own + parents + beside]
            features += [
                64 * activity[i + 1] // s if s else 0,
                64 * (activity[i] + activity[i + 2]) // s if s else 0,
                recent,
                19,
            ]
            features += [64 * min(abs(value(t, i)), 2**14) for t in (s - 2, s - 3)]
            weighted = 6144 + sum(w * f for w, f in zip(self.scale_weights[level], features))
            unrest = over(3 * restless[i + 1] + restless[i] + restless[i + 2], 4)
            exponent = log2_256(weighted >> 10) - 1536 + self.restless_of[s] + unrest + 32
            q = clamp(12 + (exponent >> 6), 0, 63)

            def normal(v):
                return clamp(v * INVERSE[q] >> 10, -1023, 1023)

            taps = [normal(v) for v in own[:2] + parents[:2] + beside]
            taps += [normal(0 if t == sibling else value(t, i)) for t in range(s - 1, s - 15, -1)]
            taps += [normal(value(t, i)) for t in range(s - 15, s - 47, -1)]
            by_squares = self.predictions[s].of(taps)
            rest = self.rests[s].of(taps)
            predicted = clamp(by_squares + rest, -2046, 2046)
            mean = over(predicted * 65536, INVERSE[q])
            expectation = Expected(mean, self.deviation[q])
            # 6.7: the bits
            magnitude = result = 0
            if self.mixed(
                1 + level,
                [
                    ("zero_near", level, size_own, size_parents),
                    ("zero_crowd", crowd, size_own, size_parents),
                    ("zero_expected", level, expected),
                    ("zero_own", s, level),
                ],
                expectation.some(),
            ):
                signs = [sign_of(v) for v in own[:2] + parents[:2]]
                sign_sibling = sign_of(value(sibling, i))
                minus = self.mixed(
                    18,
                    [
                        ("sign_near", level, 3 * signs[0] + signs[1], signs[2]),
                        ("sign_above", 3 * signs[2] + signs[3], signs[0], i % 2),
                        ("sign_neighbours", s, sign_sibling, sign_of(value(mirror, i))),
                        ("sign_before", s, sign_sibling, sign_of(value(s - 2, i))),
                    ],
                    expectation.minus(),
                )
                if minus:
                    expectation.mean = -mean
                around = (degree, density, expected, size_own)
                magnitude = self.read_magnitude(s, around, expectation)
                result = -magnitude if minus else magnitude
            self.values[s][first + i] = result
            # 6.8: what follows a value
            distance = min(abs(64 * result - mean), 2**20)
            self.deviation[q] += over(4 * distance - self.deviation[q], 80)
            excess = clamp((distance * INVERSE[q] >> 14) - 256, -256, 512)
            restless[i + 1] = clamp(restless[i + 1] + over(60 * excess, 256), -2048, 2048)
            self.restless_of[s] = clamp(self.restless_of[s] + over(15 * excess, 256), -2048, 2048)
            self.predictions[s].follow(taps, normal(result) - by_squares)
            self.rests[s].follow(taps, normal(result) - by_squares - rest)
            recent += over(64 * min(magnitude, 255) - recent, 8)
            activity[i + 1] += min(magnitude, 8)

    def read_magnitude(self, s, around, expectation):
        degree, density, expected, size_own = around
        d = 1
        while d < 29:
            k = min(d, 8) - 1
            opinions = expectation.range(2 ** (d - 1), 2**d)
            if not self.mixed(
                9 + k,
                [
                    ("class_recent", k, degree, density),
                    ("class_expected", k, expected),
                    ("class_own", s, k),
                ],
                opinions,
            ):
                break
            d += 1
        k = min(d, 8) - 1
        made = 1
        for left in reversed(range(d - 1)):  # digits after the next one
            a, b, c = made << (left + 1), (2 * made + 1) << left, (made + 1) << (left + 1)
            opinions = expectation.range(a, b, c)
            if left == d - 2:
                named = [("top_expected", k, expected), ("top_recent", k, degree, size_own)]
                digit = self.mixed(17, named, opinions)
            elif left == d - 3:
                digit = self.mixed(25, [("next_digit", k, made & 1, expected // 4)], opinions)
            else:
                digit = self.mixed(26, [], opinions)
            made = 2 * made + digit
        if made > 2**28:
            refuse("a value out of bounds")
        return made

    def steps(self):
        steps = []
        for exponent in self.exponents:
            step = math.ldexp(self.scale, -(exponent >> 1))
            if step * (ROOT_OF_HALF if exponent % 2 else 1) > 2.0**64:
                refuse("a step larger than 2^64")
            steps.append(f32(step * ROOT_OF_HALF if exponent % 2 else step))
        return steps


# ---------------------------------------------------------------- 5


def read_words(cursor, length, count):
    """Values and steps of some signals."""
    exponents = [cursor.read("b") for _ in range(count)]
    if any(exponent > 64 for exponent in exponents):
        refuse("a step larger than 2^64")
    signals = []
    for _ in range(count):
        values = []
        while len(values) < length:
            word = cursor.read("h")
            if word == -32768:
                break
            if word < -32513:
                values += [0] * (word + 32768)
            else:
                values.append(cursor.read("i") if word == -32513 else word)
        if len(values) > length:
            refuse("a run passes the end of its channel")
        signals.append(values + [0] * (length - len(values)))
    return signals, [f32(math.ldexp(1.0, exponent)) for exponent in exponents]


# ---------------------------------------------------------------- 4, trks


def number(bits, more):
    count = 0
    while count < 24 and bit_in_one(bits, more[count]):
        count += 1
    value = 1 if count else 0
    for _ in range(count - 1):
        value = 2 * value + bits.bit(32768)
    return value


def track_fields(data):
    while True:
        for length in (0, 2):
            yield length
            for _ in range(data[-1]):
                yield length + 1
        yield 4
        yield 5


class Track:
    pass


def read_track_records(data, count):
    cursor, tracks = Cursor(data), []
    for _ in range(count):
        track = Track()
        track.node = cursor.take(cursor.read("B")).decode()
        track.name = cursor.take(cursor.read("B")).decode()
        track.kind, track.flags = cursor.read("BB")
        if track.kind > 4 or track.flags > 3:
            refuse("an unknown kind of track")
        tracks.append(track)
    if cursor.rest():
        refuse("bytes after the last track")
    return tracks


class Runs:
    """Decodes held tracks, one after the other."""

    def __init__(self, bits):
        self.bits, self.count = bits, 0
        self.is_last = [Context(), Context()]
        self.length = [Context() for _ in range(24)]
        self.place = [[Context() for _ in range(24)] for _ in range(2)]
        self.recent = [0.0, 1.0] + [0.0] * 14

    def next(self, frames):
        values = []
        while len(values) < frames:
            later = 1 if values else 0
            length = frames - len(values)
            if not bit_in_one(self.bits, self.is_last[later]):
                length = 1 + number(self.bits, self.length)
                if length >= frames - len(values):
                    refuse("a run that is too long")
            place = number(self.bits, self.place[later])
            if place > 16:
                refuse("no such recent value")
            if place == 16:
                pattern = 0
                for _ in range(32):
                    pattern = pattern << 1 | self.bits.bit(32768)
                value = struct.unpack("<f", struct.pack("<I", pattern))[0]
            else:
                value = self.recent[place]
            self.recent.pop(min(place, 15))
            self.recent.insert(0, value)
            values += [value] * length
            self.count += 1
        return values


def read_tracks(payload, frames, tables):
    cursor = Cursor(payload)
    count, curves, basis, size, runs, stream_bytes = cursor.read("HHBIII")
    stream = cursor.take(stream_bytes)
    bits = RangeDecoder(cursor.rest())
    tracks = read_track_records(decode_joint_bytes(bits, size, track_fields), count)
    held = Runs(bits)
    for track in tracks:
        if not track.flags & 1:
            track.values = held.next(frames)
    bits.expect_end()
    coded = [track for track in tracks if track.flags & 1]
    if held.count != runs or len(coded) != curves:
        refuse("other tracks than was promised")
    if coded:
        decoded = Stream(stream, frames, [(s - 1, -1) for s in range(curves)], tables)
        for track, values, step in zip(coded, decoded.values, decoded.steps()):
            track.values = inverse_transform(values, step, basis, 8)
    return tracks


# ---------------------------------------------------------------- 7


def inverse_transform(values, step, basis, limit):
    bands = Bands(len(values))
    wide = any(
        abs(value) > limit / step * 2 ** (0.5 * bands.depth(b))
        for b in range(bands.count)
        for value in values[bands.first(b) : bands.first(b) + bands.size(b)]
    )
    rounded = float if wide else f32
    root = ROOT_OF_HALF if wide else ROOT_OF_HALF_32

    def band(b):
        depth = bands.depth(b)
        gain = 1 / 2 ** (depth // 2) * (root if depth % 2 else 1)
        first = bands.first(b)
        factor = rounded(step * rounded(gain))
        return [rounded(rounded(v) * factor) for v in values[first : first + bands.size(b)]]

    e = band(0)
    for b in range(1, bands.count):
        d = band(b)
        e = next_level(e, d, basis, rounded)
    return [f32(sample) for sample in e]


def next_level(e, d, basis, r):
    def updated(i, before, after):
        return r(e[i] - r(0.25 * r(d[before] + d[after])))

    evens, odds = len(e), len(d)
    if basis == 0:
        e = [updated(i, i, i) if i < odds else e[i] for i in range(evens)]
    else:
        e = [updated(i, max(i - 1, 0), min(i, odds - 1)) for i in range(evens)]
    samples = []
    for i in range(evens):
        samples.append(e[i])
        if i < odds:
            samples.append(r(d[i] + prediction(e, i, basis, r)))
    return samples


def prediction(e, i, basis, r):
    count = len(e)
    if basis == 0:
        return e[i]
    if 0 < i < count - 2:
        near, far = (9 / 16, -1 / 16) if basis == 2 else (0.5, 0.0)
        return r(r(near * r(e[i] + e[i + 1])) + r(far * r(e[i - 1] + e[i + 2])))
    if i + 1 == count:
        first, weights = count - 2, (-1 / 2, 3 / 2)
    elif basis == 1 or count == 2:
        first, weights = i, (1 / 2, 1 / 2)
    elif count == 3:
        first, weights = 0, (3 / 8, 3 / 4, -1 / 8) if i == 0 else (-1 / 8, 3 / 4, 3 / 8)
    elif i == 0:
        first, weights = 0, (5 / 16, 15 / 16, -5 / 16, 1 / 16)
    else:
        first, weights = count - 4, (1 / 16, -5 / 16, 15 / 16, 5 / 16)
    terms = [r(w * e[first + n]) for n, w in enumerate(weights)] + [0.0] * (4 - len(weights))
    return r(r(terms[0] + terms[1]) + r(terms[2] + terms[3]))


def limits_of(joints, effectors, coding):
    channels = sum(len(joint.kinds) for joint in joints)
    if coding != 3:
        return [8.0] * (channels + 3 * effectors)
    reach = []
    for joint in joints:
        x, y, z = joint.end_site
        squares = f32(f32(f32(x * x) + f32(y * y)) + f32(z * z))
        reach.append(f32(math.sqrt(squares)))
    for j in reversed(range(len(joints))):
        if joints[j].parent >= 0:
            length = f32(math.sqrt(sum(v * v for v in joints[j].offset)))
            p = joints[j].parent
            reach[p] = max(reach[p], f32(reach[j] + length))
    limits = []
    for j, joint in enumerate(joints):
        turn = f32(1000 / max(reach[j], f32(0.01)))
        limits += [turn if kind >= 3 else 1000.0 for kind in joint.kinds]
    return limits + [1000.0] * (3 * effectors)


# ---------------------------------------------------------------- 9

IDENTITY = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]


def rotation_of(wxyz):
    w, x, y, z = wxyz
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def rotation_about(axis, angle):
    vector = [math.sin(angle / 2) if i == axis else 0.0 for i in range(3)]
    return rotation_of([math.cos(angle / 2)] + vector)


def product(*matrices):
    result = matrices[0]
    for m in matrices[1:]:
        result = [
            [sum(result[i][k] * m[k][j] for k in range(3)) for j in range(3)] for i in range(3)
        ]
    return result


def transposed(m):
    return [[m[j][i] for j in range(3)] for i in range(3)]


def turned(m, v):
    return [sum(m[i][k] * v[k] for k in range(3)) for i in range(3)]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def less(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    return math.sqrt(dot(a, a))


def pose(joints, row):
    """Each joint's origin and rotation in the world, and its axes there, one for each channel."""
    places = []
    for joint in joints:
        origin, world = (places[joint.parent][:2] if joint.parent >= 0 else ([0, 0, 0], IDENTITY))
        at = list(joint.offset)
        rotation = product(world, joint.axes, joint.before)
        axes = []
        for c, kind in enumerate(joint.kinds):
            value = row[joint.first_channel + c]
            axes.append([rotation[i][kind % 3] for i in range(3)])
            if kind < 3:
                at[kind] += value
            else:
                rotation = product(rotation, rotation_about(kind - 3, value))
        rotation = product(rotation, joint.after, transposed(joint.axes))
        places.append((plus(origin, turned(world, at)), rotation, axes))
    return places


def read_axes(payload, joints):
    cursor = Cursor(payload)
    able = [
        joint
        for joint in joints
        if joint.parent >= 0 and sorted(k for k in joint.kinds if k >= 3) == [3, 4, 5]
    ]
    flags = cursor.take((len(able) + 7) // 8)
    for i in range(8 * len(flags)):
        if not flags[i // 8] >> (i % 8) & 1:
            continue
        word = cursor.read("I")
        if i >= len(able) or word >> 30:
            refuse("axes turned that are none")
        numbers = [(word >> (5 * n) & 31) - 32 * (word >> (5 * n + 4) & 1) for n in range(6)]
        able[i].before, able[i].after = fixed_turn(numbers[:3]), fixed_turn(numbers[3:])
    if cursor.rest():
        refuse("AXES of another size")


def fixed_turn(steps):
    count = norm(steps)
    if count == 0:
        return IDENTITY
    half = count * math.pi / 32
    return rotation_of([math.cos(half)] + [math.sin(half) * step / count for step in steps])


# ---------------------------------------------------------------- 10


class Limb:
    def __init__(self, joints, effectors, numbers):
        self.joints, self.numbers = joints, numbers
        self.effectors = [effectors[n] for n in numbers]
        self.chains, links = [], set()
        for joint, top in self.effectors:
            self.chains.append(chain_of(joints, joint, top))
            while joint >= 0:
                links.add(joint)
                joint = joints[joint].parent
        self.links = sorted(links)
        self.turns = [
            (j, c)
            for j in self.links
            if any(j in chain for chain in self.chains)
            for c, kind in enumerate(joints[j].kinds)
            if kind >= 3
        ]

    def channel(self, a):
        j, c = self.turns[a]
        return self.joints[j].first_channel + c

    def kind(self, a):
        j, c = self.turns[a]
        return self.joints[j].kinds[c] - 3

    def set(self, row):
        self.row = list(row)
        self.update()

    def update(self):
        self.places = pose(self.joints, self.row)

    def turn(self, a, by):
        self.row[self.channel(a)] += by
        self.update()

    def place(self, e):
        return self.places[self.effectors[e][0]][0]

    def center(self, a):
        return self.places[self.turns[a][0]][0]

    def axis(self, a):
        j, c = self.turns[a]
        return self.places[j][2][c]

    def moves(self, a, e):
        return self.turns[a][0] in self.chains[e]

    def miss(self, targets):
        return max(norm(less(target, self.place(e))) for e, target in enumerate(targets))

    def has_two_bones(self):
        if len(self.effectors) != 1 or len(self.turns) != 4:
            return False
        joints = [j for j, _ in self.turns]
        return (
            joints[0] == joints[2] != joints[3] and len({self.kind(a) for a in range(3)}) == 3
        )


def chain_of(joints, joint, top):
    chain = []
    while joint != top:
        joint = joints[joint].parent
        if joint < 0:
            refuse("a chain that does not begin above its effector")
        if any(kind >= 3 for kind in joints[joint].kinds):
            chain.append(joint)
    return chain


def limbs_of(joints, effectors):
    chains = [set(chain_of(joints, *effector)) for effector in effectors]
    shares = []
    for chain in chains:
        shares.append({f for f, other in enumerate(chains) if chain & other})
    groups = []
    for e in range(len(effectors)):
        joined, kept = [e], []
        for group in groups:
            if shares[e] & set(group):
                joined = group + joined
            else:
                kept.append(group)
        groups = kept + [joined]
    return [Limb(joints, effectors, group) for group in groups]


def correct(limbs, solver, row, differences):
    row = list(row)
    for limb in limbs:
        limb.set(row)
        targets = [
            plus(limb.place(i), differences[3 * e : 3 * e + 3]) for i, e in enumerate(limb.numbers)
        ]
        (cyclic_descent if solver == 1 else nearest_pose)(limb, targets)
        for a in range(len(limb.turns)):
            row[limb.channel(a)] = f32(limb.row[limb.channel(a)])
    return row


def cyclic_descent(limb, targets):
    for _ in range(60):
        if limb.miss(targets) <= 0.01:
            return
        for a in reversed(range(len(limb.turns))):
            along = across = 0.0
            axis = limb.axis(a)
            for e, target in enumerate(targets):
                if not limb.moves(a, e):
                    continue
                arm, wanted = less(limb.place(e), limb.center(a)), less(target, limb.center(a))
                along += dot(arm, wanted) - dot(axis, arm) * dot(axis, wanted)
                across += dot(axis, cross(arm, wanted))
            if along or across:
                limb.turn(a, math.atan2(across, along))


def nearest_pose(limb, targets):
    if limb.miss(targets) <= 0.01:
        return
    if limb.has_two_bones() and two_bones(limb, targets[0]):
        return
    angles = range(len(limb.turns))
    ease = [1 / (1 + disturbance(limb, a)) for a in angles]
    for _ in range(12):
        if limb.miss(targets) <= 0.01:
            return
        error, jacobian = [], []
        for e, target in enumerate(targets):
            error += less(target, limb.place(e))
            columns = [
                cross(limb.axis(a), less(limb.place(e), limb.center(a)))
                if limb.moves(a, e)
                else [0.0, 0.0, 0.0]
                for a in angles
            ]
            jacobian += [[column[i] for column in columns] for i in range(3)]
        normal = [
            [
                sum(p[a] * ease[a] * r[a] for a in angles) + (0.01 if i == j else 0)
                for j, r in enumerate(jacobian)
            ]
            for i, p in enumerate(jacobian)
        ]
        y = solved(normal, error)
        steps = [ease[a] * sum(row[a] * v for row, v in zip(jacobian, y)) for a in angles]
        longest = max(abs(step) for step in steps)
        shrink = 0.35 / longest if longest > 0.35 else 1
        for a in angles:
            limb.row[limb.channel(a)] += steps[a] * shrink
        limb.update()


def disturbance(limb, a):
    total = 0.0
    for j in limb.links:
        if j > limb.turns[a][0]:
            velocity = cross(limb.axis(a), less(limb.places[j][0], limb.center(a)))
            total += dot(velocity, velocity)
    return total / len(limb.links)


def solved(matrix, right):
    rows = [row + [value] for row, value in zip(matrix, right)]
    for i in range(len(rows)):
        pivot = max(range(i, len(rows)), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(len(rows)):
            if k != i:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [x - factor * y for x, y in zip(rows[k], rows[i])]
    return [row[-1] / row[i] for i, row in enumerate(rows)]


def two_bones(limb, target):
    wanted = less(target, limb.center(0))
    thigh, shin = less(limb.center(3), limb.center(0)), less(limb.place(0), limb.center(3))
    axis = limb.axis(3)
    fixed = dot(axis, shin) * dot(axis, thigh)
    along, across = dot(thigh, shin) - fixed, dot(thigh, cross(axis, shin))
    size = math.hypot(along, across)
    bend = 0.0
    if size > 0:
        reach = (dot(wanted, wanted) - dot(thigh, thigh) - dot(shin, shin)) / 2 - fixed
        spread, middle = math.acos(clamp(reach / size, -1.0, 1.0)), math.atan2(across, along)
        one = math.remainder(middle + spread, 2 * math.pi)
        other = math.remainder(middle - spread, 2 * math.pi)
        bend = one if abs(one) < abs(other) else other
    if not abs(bend) <= 0.35:
        return False
    limb.turn(3, bend)
    reached = less(limb.place(0), limb.center(0))
    if norm(reached) > 0 and norm(wanted) > 0:
        hip = limb.joints[limb.turns[0][0]]
        world = limb.places[hip.parent][1] if hip.parent >= 0 else IDENTITY
        w = product(world, hip.axes, hip.before)
        now = [rotation_about(limb.kind(a), limb.row[limb.channel(a)]) for a in range(3)]
        m = product(transposed(w), shortest(reached, wanted), w, *now)
        for a, angle in enumerate(three_angles(m, limb)):
            limb.row[limb.channel(a)] = angle
        limb.update()
    return True


def shortest(a, b):
    a, b = [x / norm(a) for x in a], [x / norm(b) for x in b]
    axis, w = cross(a, b), 1 + dot(a, b)
    if w < 1e-12:
        least = min(range(3), key=lambda i: abs(a[i]))
        axis, w = cross(a, IDENTITY[least]), 0.0
    size = math.sqrt(w * w + dot(axis, axis))
    return rotation_of([w / size] + [x / size for x in axis])


def three_angles(m, limb):
    i, j, k = (limb.kind(a) for a in range(3))
    now = [limb.row[limb.channel(a)] for a in range(3)]
    sign = 1 if (i + 1) % 3 == j else -1
    a = math.atan2(-sign * m[j][k], m[k][k]) if math.hypot(m[i][i], m[i][j]) > 1e-9 else now[0]
    rest = product(transposed(rotation_about(i, a)), m)
    b, c = math.atan2(sign * rest[i][k], rest[k][k]), math.atan2(sign * rest[j][i], rest[j][j])
    found = []
    for angles in ((a, b, c), (a + math.pi, math.pi - b, c + math.pi)):
        near = [x - 2 * math.pi * round((x - n) / (2 * math.pi)) for x, n in zip(angles, now)]
        found.append(near)
    return min(found, key=lambda angles: norm(less(angles, now)))


# ---------------------------------------------------------------- 3, 4, 8


def sections_of(data):
    """The sections of a file, by their tags."""
    file = Cursor(data)
    if file.take(4) != b"MCPR" or file.read("H") != 1:
        refuse("not a .mcpr file of version 1")
    sections = {}
    for _ in range(file.read("H")):
        head = file.take(8)
        crc = file.read("I")
        payload = file.take(struct.unpack("<I", head[4:])[0])
        if zlib.crc32(payload, zlib.crc32(head)) != crc:
            refuse("a checksum differs")
        tag = head[:4].decode()
        if tag == "TIER":
            end = file.at
            bands, pieces = read_tiers(payload)
            sections["bands left out"] = bands
            continue
        sections[tag] = payload
    if "bands left out" in sections:
        if file.at - end != pieces[0][0]:
            refuse("the first tier does not end where TIER says")
        sections["pieces"] = [file.take(size) for size, _ in pieces[1:]]
        if [zlib.crc32(piece) for piece in sections["pieces"]] != [crc for _, crc in pieces[1:]]:
            refuse("a checksum of a tier differs")
    if file.rest():
        refuse("bytes after the last section")
    return sections


def read_tiers(payload, of_file=True):
    """The bands that each tier lacks, and in a file the size of its bytes and their checksum."""
    cursor = Cursor(payload)
    count = cursor.read("B")
    bands, pieces = [], []
    for t in range(count):
        if of_file:
            size = grouped_number(cursor)
            pieces.append((size, cursor.read("I") if t > 0 else None))
        bands.append(cursor.read("BHH")[0] if t < count - 1 else 0)
    if cursor.rest() or count < 2 or bands != sorted(set(bands), reverse=True):
        refuse("TIER makes no sense")
    return bands, pieces


class Clip:
    def __init__(self, sections, tables, change_joints=None):
        self.sections = sections
        self.tables = tables
        self.joints = read_joints(sections["JNTS"])
        if change_joints:
            change_joints(self.joints)
        self.channels = sum(len(joint.kinds) for joint in self.joints)
        description = Cursor(self.sections["CLIP"]).read("dIBBBBQff")
        _, self.frames, self.basis, self.coding = description[:4]
        self.solver, self.effectors = 0, []
        if "IKCO" in self.sections:
            cursor = Cursor(self.sections["IKCO"])
            self.solver, count = cursor.read("BB")
            self.effectors = [cursor.read("HH") for _ in range(count)]
        if "AXES" in self.sections:
            read_axes(self.sections["AXES"], self.joints)
        self.left_out = self.bands_left_out()
        self.rows = self.decode()

    def bands_left_out(self):
        """The finest bands that the tiers lack which are there."""
        bands = self.sections.get("bands left out", [0])
        there = len(self.sections.get("pieces", []))
        if there >= len(bands):
            refuse("a tier too many")
        return bands[there]

    def decode(self):
        limits = limits_of(self.joints, len(self.effectors), self.coding)
        if self.coding == 3:
            rows = self.decode_streams(limits)
        else:
            rows = self.decode_words(limits)
        limbs = limbs_of(self.joints, self.effectors)
        if limbs:
            rows = [
                correct(limbs, self.solver, row[: self.channels], row[self.channels :])
                for row in rows
            ]
        if "ENDS" in self.sections and not self.left_out:
            self.add_ends(rows)
        return rows

    def decode_words(self, limits):
        words = self.sections["MOTN"]
        if self.coding == 2:
            words = zlib.decompress(words, -15)
        cursor = Cursor(words)
        samples = []
        for count in (self.channels, 3 * len(self.effectors)):
            signals, steps = read_words(cursor, self.frames, count)
            for values, step in zip(signals, steps):
                samples.append(inverse_transform(values, step, self.basis, limits[len(samples)]))
        if cursor.rest():
            refuse("words after the last channel")
        return [[signal[t] for signal in samples] for t in range(self.frames)]

    def decode_streams(self, limits):
        pairs = neighbours(self.joints, len(self.effectors))
        pieces = [self.sections["MOTN"]] + self.sections.get("pieces", [])
        length, overlap, sizes = self.frames, 0, [[len(piece)] for piece in pieces]
        if "SEGS" in self.sections:
            cursor = Cursor(self.sections["SEGS"])
            length, overlap, count = cursor.read("III")
            sizes = [[cursor.read("I") for _ in range(count)] for _ in pieces]
        pieces = [Cursor(piece) for piece in pieces]
        rows, self.steps = [], []
        for k, of_pieces in enumerate(zip(*sizes)):
            first = k * (length - overlap)
            frames = min(length, self.frames - first)
            coded = b"".join(piece.take(size) for piece, size in zip(pieces, of_pieces))
            stream = Stream(
                coded, frames, pairs, self.tables, self.sections.get("PRIO"), self.left_out
            )
            self.steps.append(stream.steps())
            samples = [
                inverse_transform(values, step, self.basis, limit)
                for values, step, limit in zip(stream.values, self.steps[-1], limits)
            ]
            for i in range(frames):
                row = [signal[i] for signal in samples]
                if k > 0 and i < overlap:
                    w = f32((i + 1) / (overlap + 1))
                    row = [
                        f32(a + f32(w * f32(b - a))) for a, b in zip(rows[first + i], row)
                    ]
                    rows[first + i] = row
                else:
                    rows.append(row)
        return rows

    def add_ends(self, rows):
        cursor = Cursor(self.sections["ENDS"])
        reaches, exponents = list(cursor.read("BB")), list(cursor.read("bb"))
        if reaches[1] & 128:
            reaches[1] &= 127
            for values, value in zip((reaches, exponents), cursor.read("Bb")):
                values.append(value)
        bits = RangeDecoder(cursor.rest())
        more = [Context() for _ in range(24)]
        lacking = [[] for _ in reaches]
        for end in range(len(reaches)):
            steps = self.steps[0 if end == 0 else -1]
            for c in range(self.channels):
                value = number(bits, more)
                if value and bits.bit(32768):
                    value = -value
                step = f32(math.ldexp(steps[c], -(exponents[end] >> 1)))
                if exponents[end] % 2:
                    step = f32(step * ROOT_OF_HALF_32)
                lacking[end].append(f32(value * step))
        bits.expect_end()
        for t, row in enumerate(rows):
            for end in range(len(reaches)):
                away = t if end == 0 else len(rows) - 1 - t
                if away < reaches[end]:
                    left = f32((reaches[end] - away) / reaches[end])
                    share = f32(left * left)
                    if end == 2:
                        share = f32(away * share)
                    for c in range(self.channels):
                        row[c] = f32(row[c] + f32(share * lacking[end][c]))

    def track_rows(self):
        tracks = read_tracks(self.sections["trks"], self.frames, self.tables)
        return [[track.values[t] for track in tracks] for t in range(self.frames)]

    def positions(self):
        return [[x for place in pose(self.joints, row) for x in place[0]] for row in self.rows]


def expected_rows(path, width):
    """Rows of numbers and how near they are to be."""
    if path.endswith(".csv"):
        lines = open(path, encoding="utf-8").read().splitlines()[1:]
        return [[float(cell) for cell in line.split(",")][-width:] for line in lines], 1e-4
    data = open(path, "rb").read()
    values = struct.unpack(f"<{len(data) // 4}f", data)
    return [values[i : i + width] for i in range(0, len(values), width)], 0


def main():
    options = [argument for argument in sys.argv[1:] if argument.startswith("--")]
    page, clip_path, expected_path = [a for a in sys.argv[1:] if not a.startswith("--")]
    clip = Clip(sections_of(open(clip_path, "rb").read()), Tables(open(page, encoding="utf-8").read()))
    rows = clip.positions() if "--positions" in options else clip.rows
    if "--tracks" in options:
        rows = clip.track_rows()
    expected, near = expected_rows(expected_path, len(rows[0]))
    if "--positions" in options:
        near = 1e-4
    worst = max(abs(a - b) for row, other in zip(rows, expected) for a, b in zip(row, other))
    print(f"{clip_path}: {len(rows)} frames of {len(rows[0])} numbers, at most {worst:g} off")
    return 0 if len(rows) == len(expected) and worst <= near else 1


if __name__ == "__main__":
    sys.exit(main())
