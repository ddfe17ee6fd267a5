"""Files that carry checksums of their blocks."""
from __future__ import annotations

import io
import os
import pathlib
import struct
import zlib

import numpy as np


class SealedFile(io.RawIOBase):
    """The content of a file that carries checksums of its blocks behind it, as tanktread writes frames.h5.

    A read of damaged bytes raises OSError. Without a seal (`sealed` false) nothing is known of the bytes.
    """
    BLOCK = 4096
    FOOTER = struct.Struct("<8sQI")  # "tt-seal1", bytes of content, CRC-32 of the table and the footer before it

    def __init__(self, path: os.PathLike):
        self.path = pathlib.Path(path)
        self._file = open(path, "rb", buffering=0)
        self._at = 0
        self.size = self._file.seek(0, os.SEEK_END)
        self.sealed = self._read_seal()

    def _read_seal(self) -> bool:
        end = self.size
        if end < self.FOOTER.size:
            return False
        footer = self._read_at(end - self.FOOTER.size, self.FOOTER.size)
        magic, content, stated = self.FOOTER.unpack(footer)
        table_size = 4 * -(-content // self.BLOCK)
        if magic != b"tt-seal1" or content + table_size + self.FOOTER.size != end:
            return False
        table = self._read_at(content, table_size)
        if zlib.crc32(footer[:-4], zlib.crc32(table)) != stated:
            return False
        self._table = np.frombuffer(table, "<u4")
        self.size = content
        return True

    def _read_at(self, offset: int, count: int) -> bytes:
        self._file.seek(offset)
        parts = []
        while count > 0:
            part = self._file.read(count)
            if not part:
                raise OSError(f"{self.path}: cut short")
            parts.append(part)
            count -= len(part)
        return b"".join(parts)

    def close(self):
        self._file.close()
        super().close()

    def readable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        self._at = offset + {os.SEEK_SET: 0, os.SEEK_CUR: self._at, os.SEEK_END: self.size}[whence]
        return self._at

    def tell(self) -> int:
        return self._at

    def readinto(self, buffer) -> int:
        wanted = memoryview(buffer).cast("B")
        end = min(self._at + len(wanted), self.size)
        if end <= self._at:
            return 0
        first = self._at // self.BLOCK
        whole = self._read_at(first * self.BLOCK, min(-(-end // self.BLOCK) * self.BLOCK, self.size) - first * self.BLOCK)
        if self.sealed:
            for k in range(0, len(whole), self.BLOCK):
                if zlib.crc32(whole[k:k + self.BLOCK]) != self._table[first + k // self.BLOCK]:
                    raise OSError(f"{self.path}: damaged")
        start = self._at - first * self.BLOCK
        count = end - self._at
        wanted[:count] = whole[start:start + count]
        self._at = end
        return count
