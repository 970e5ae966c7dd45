"""JSON-RPC 2.0 over standard input and output, as docs/medium-protocol.md says."""
import json
import os
import select

LONGEST_HEADER, LONGEST_BODY = 1024, 64 << 20


class Refusal(Exception):
    """A request that cannot be served: the error that it is answered with."""

    def __init__(self, code, sentence):
        super().__init__(sentence)
        self.code = code


class Closed(Exception):
    """The host is gone, or what came is not the protocol."""


class Wire:
    def __init__(self, source=0, sink=1):
        self._source, self._sink, self._bytes = source, sink, bytearray()

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}, ensure_ascii=False, allow_nan=False).encode()
        data = memoryview(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        while data:
            try:
                data = data[os.write(self._sink, data):]
            except BlockingIOError:
                select.select([], [self._sink], [])
            except OSError as error:
                raise Closed(str(error)) from None

    def notify(self, method, **params):
        self.send({"method": method, "params": params})

    def receive(self, timeout):
        """The messages that have come within `timeout` seconds (None: waits for one)."""
        if not select.select([self._source], [], [], timeout)[0]:
            return
        data = os.read(self._source, 1 << 16)
        if not data:
            raise Closed("")
        self._bytes += data
        while (body := self._take()) is not None:
            try:
                message = json.loads(body)
            except (ValueError, RecursionError):
                raise Closed("a message that is not JSON") from None
            if not isinstance(message, dict) or message.get("jsonrpc") != "2.0":
                raise Closed("a message that is not a JSON-RPC 2.0 object")
            yield message

    def _take(self):
        end = self._bytes.find(b"\r\n\r\n", 0, LONGEST_HEADER)
        if end < 0:
            if len(self._bytes) >= LONGEST_HEADER:
                raise Closed("a header of more than 1 KiB")
            return None
        length = None
        for line in bytes(self._bytes[:end]).split(b"\r\n"):
            name, _, value = line.partition(b":")
            if name.strip().lower() == b"content-length" and value.strip().isdigit():
                length = int(value)
        if length is None or not 0 < length <= LONGEST_BODY:
            raise Closed("a header without a fitting Content-Length")
        if len(self._bytes) < end + 4 + length:
            return None
        body = bytes(self._bytes[end + 4:end + 4 + length])
        del self._bytes[:end + 4 + length]
        return body
