#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A reader of packed banks written from FORMAT.md alone, to show that the page is enough.

Slow and without limits: for tests only. Clips are decoded by format_reader.py.

Usage: bank_reader.py FORMAT.md BANK.mcpk NAME=EXPECTED.f32...
       compares the channels of clips with 32-bit floats, frame after frame (equal to the bit), of
       those tiers that the bank has; the bank has these clips and no others
"""
import struct
import sys
import zlib

from format_reader import Clip, Cursor, Tables, expected_rows, read_tiers, grouped_number as number, refuse

ORDERS = [(3, 4, 5), (3, 5, 4), (4, 3, 5), (4, 5, 3), (5, 3, 4), (5, 4, 3)]
NONE = 2**32 - 1
HEAD = 104  # bytes
CLIPS_OF_BLOCK = 16


class Bank:
    def __init__(self, data):
        self.data = data
        head = Cursor(data[:HEAD])
        if head.take(4) != b"MCPK" or head.read("HH") != (2, 0):
            refuse("not a packed bank of version 2")
        size, index, index_size, items, items_size, tables, tables_size = head.read("7Q")
        self.count, *counts = head.read("6I")
        index_crc, items_crc, tables_crc, head_crc = head.read("4I")
        if size != len(data) or zlib.crc32(data[: HEAD - 4]) != head_crc:
            refuse("another head than was written")
        self.index = data[index : index + index_size]
        items = data[items : items + items_size]
        self.tables = data[tables : tables + tables_size]
        for region, crc in (self.index, index_crc), (items, items_crc), (self.tables, tables_crc):
            if zlib.crc32(region) != crc:
                refuse("a checksum differs")
        begins = struct.unpack_from(f"<{sum(counts) + 1}I", items)
        found = [items[a:b] for a, b in zip(begins, begins[1:])]
        self.parts, self.outlines = found[: counts[0]], found[counts[0] : counts[0] + counts[1]]
        self.tiers = self.read_tiers(tables + tables_size)

    def read_tiers(self, end):
        """The pieces of all clips, of each tier but the first that the bank has."""
        if not self.tables:
            return []
        cursor = Cursor(self.tables)
        heads = [cursor.read("QQI") for _ in range(cursor.read("I") - 1)]
        tiers = []
        for place, size, crc in heads:
            begins = cursor.read(f"{self.count + 1}I")
            if place != end or begins[0] != 0 or begins[-1] != size:
                refuse("tiers that do not follow each other")
            end += size
            if end > len(self.data):
                continue  # the bank was cut
            if zlib.crc32(self.data[place:end]) != crc:
                refuse("a checksum of a tier differs")
            tiers.append([self.data[place + a : place + b] for a, b in zip(begins, begins[1:])])
        if cursor.rest() or len(self.data) not in [end] + [place for place, _, _ in heads]:
            refuse("bytes after the tables, or after the last tier")
        return tiers

    def entries(self):
        """Name, bytes and outline of each clip, and its pieces of the tiers but the first."""
        last, clip = b"", 0
        blocks = Cursor(self.index)
        heads = [blocks.read("QII") for _ in range(-(-self.count // CLIPS_OF_BLOCK))]
        for block, (begin, first, checksum) in enumerate(heads):
            cursor = Cursor(self.index[first:])
            place, before = begin, b""
            for _ in range(min(CLIPS_OF_BLOCK, self.count - CLIPS_OF_BLOCK * block)):
                head = cursor.read("B")
                dropped, more = head & 7, head >> 3 & 7
                if dropped == 7:
                    dropped += number(cursor)
                if more == 7:
                    more += number(cursor)
                name = before[: len(before) - dropped] + cursor.take(more + 1)
                if name <= last:
                    refuse("names that are not in order")
                last = before = name
                size = number(cursor)
                if head & 64:
                    outline = number(cursor)
                if head & 128:
                    number(cursor)  # of its tags
                pieces = [tier[clip] for tier in self.tiers]
                yield name.decode(), self.data[place : place + size], self.outlines[outline], pieces
                place += size
                clip += 1
            if zlib.crc32(self.data[begin:place]) != checksum:
                refuse("a checksum of clips differs")

    def sections(self, clip, outline, pieces):
        """The sections of a packed clip, and what says its orders."""
        cursor, outline = Cursor(clip), Cursor(outline)
        count, orders_size = outline.read("HH")
        tags = [(outline.take(4), outline.read("I")) for _ in range(count)]
        if orders_size & 2**15:
            errors = cursor.take(8)
        else:
            codes = [cursor.read("H"), cursor.read("H")]
            errors = struct.pack("<2I", *(c and c + 106 * 2**11 << 12 for c in codes))
        orders_size &= 2**15 - 1
        frames = number(cursor)
        own = [tag for tag, part in tags if part == NONE]
        sizes = {tag: number(cursor) for tag in own if tag not in (b"MOTN", b"COMP")}
        orders = cursor.take(orders_size)
        rest = len(clip) - cursor.at - sum(sizes.values())  # MOTN's or COMP's
        sections = {}
        for tag, part in tags:
            if part == NONE:
                sections[tag.decode()] = cursor.take(sizes.get(tag, rest))
                continue
            if self.parts[part][:4] != tag:
                refuse("a part of another section")
            sections[tag.decode()] = self.parts[part][4:]
        if cursor.rest():
            refuse("bytes after the last section")
        description = sections["CLIP"]
        sections["CLIP"] = (
            description[:8] + struct.pack("<I", frames) + description[12:-8] + errors
        )
        tiers = 1
        if "TIER" in sections:
            sections["bands left out"], _ = read_tiers(sections.pop("TIER"), of_file=False)
            tiers = len(sections["bands left out"])
            sections["pieces"] = pieces[: tiers - 1]
        if any(pieces[tiers - 1 :]):
            refuse("a piece of a tier that the clip does not have")
        return sections, orders


def set_orders(joints, orders):
    """Those of joints that turn about three different axes, three to a byte."""
    digits = [byte // 6**k % 6 for byte in orders for k in range(3)]
    for joint in joints:
        turns = [i for i, kind in enumerate(joint.kinds) if kind >= 3]
        if digits and sorted(joint.kinds[i] for i in turns) == [3, 4, 5]:
            for i, kind in zip(turns, ORDERS[digits.pop(0)]):
                joint.kinds[i] = kind
    if any(digits):
        refuse("orders of no joint")


def main():
    page, path, *wanted = sys.argv[1:]
    tables = Tables(open(page, encoding="utf-8").read())
    wanted = dict(one.split("=", 1) for one in wanted)
    bank = Bank(open(path, "rb").read())
    wrong = 0
    for name, bytes_of_clip, outline, pieces in bank.entries():
        sections, orders = bank.sections(bytes_of_clip, outline, pieces)
        clip = Clip(sections, tables, lambda joints: set_orders(joints, orders))
        expected, _ = expected_rows(wanted.pop(name), len(clip.rows[0]))
        same = [list(row) for row in expected] == [list(row) for row in clip.rows]
        print(f"{path}: {name}: {len(clip.rows)} frames, {'the same' if same else 'others'}")
        wrong += not same
    for name in wanted:
        print(f"{path}: no clip {name}")
    return 0 if not wrong and not wanted else 1


if __name__ == "__main__":
    sys.exit(main())
