# `etalon serve` as a client meets it: over HTTP, and with a browser driven through a pipe.
import http.client
import json
import os
import signal
import socket
import subprocess
import threading
import time
from urllib.parse import urlsplit

PATIENCE = 60  # seconds; reached only where something is wrong


def until(condition):
    """Returns what the condition gives as soon as that is true."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.02)
    raise AssertionError("waited in vain")


class Served:
    """A running `etalon serve`."""

    def __init__(self, program, *arguments):
        self.process = subprocess.Popen([program, "serve", *arguments], stdout=subprocess.PIPE, text=True)
        self.url = self.process.stdout.readline().strip()
        parts = urlsplit(self.url)
        self.port, self.path = parts.port, parts.path
        assert parts.scheme == "http" and parts.hostname == "127.0.0.1", self.url
        assert len(self.path.strip("/")) == 32, self.url

    def ask(self, name="", method="GET", host=None, path=None):
        """Returns status, headers and body."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE)
        headers = {"Host": host} if host else {}
        connection.request(method, self.path + name if path is None else path, headers=headers)
        reply = connection.getresponse()
        result = reply.status, reply.headers, reply.read()
        connection.close()
        return result

    def connection(self):
        return socket.create_connection(("127.0.0.1", self.port), PATIENCE)

    def memory(self):
        """Returns the bytes that the program has in memory."""
        with open("/proc/%d/statm" % self.process.pid) as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def open_files(self):
        """Returns the number of files and connections that the program has open."""
        return len(os.listdir("/proc/%d/fd" % self.process.pid))

    def state(self):
        return json.loads(self.ask("state.json")[2])

    def has_ended(self):
        return self.process.poll() is not None

    def end(self):
        """Returns the exit status."""
        return self.process.wait(PATIENCE)

    def interrupt(self):
        self.process.send_signal(signal.SIGINT)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if not self.has_ended():
            self.process.kill()
            self.process.wait()


class Relay:
    """Passes connections to a port of this machine on, as `ssh -L` does, until it is cut."""

    def __init__(self, port):
        self.target, self.is_cut = port, False
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        threading.Thread(target=self.run, daemon=True).start()

    def run(self):
        while True:
            client = self.listener.accept()[0]
            if self.is_cut:
                client.close()
            else:
                threading.Thread(target=self.pass_on, args=(client,), daemon=True).start()

    def pass_on(self, client):
        """Passes one request on, in one piece as browsers send it, and its answer back."""
        try:
            with client, socket.create_connection(("127.0.0.1", self.target)) as server:
                server.sendall(client.recv(1 << 16))
                while piece := server.recv(1 << 16):
                    client.sendall(piece)
        except OSError:  # one of them has ended
            pass


class Browser:
    """A headless Chromium with one page; messages are JSON texts that end in a zero byte."""

    def __init__(self, name, profile):
        their_input, self.output = os.pipe()
        self.input, their_output = os.pipe()

        def place_pipes():  # the browser reads from descriptor 3 and writes to 4
            os.dup2(their_input, 63)
            os.dup2(their_output, 64)
            os.dup2(63, 3)
            os.dup2(64, 4)

        self.process = subprocess.Popen(
            [name, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
             "--disable-dev-shm-usage", "--disable-background-networking", "--disable-component-update",
             "--disable-sync", "--remote-debugging-pipe", "--user-data-dir=" + profile, "about:blank"],
            preexec_fn=place_pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(their_input)
        os.close(their_output)
        self.unread, self.count, self.session, self.complaints = b"", 0, None, []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Runtime", "Log", "Page"):
            self.call(domain + ".enable")

    def message(self):
        while b"\0" not in self.unread:
            read = os.read(self.input, 1 << 20)
            assert read, "the browser has ended"
            self.unread += read
        first, self.unread = self.unread.split(b"\0", 1)
        return json.loads(first)

    def call(self, method, **parameters):
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.output, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == self.count:
                assert "error" not in answer, answer
                return answer["result"]
            if answer.get("method") in ("Log.entryAdded", "Runtime.exceptionThrown", "Runtime.consoleAPICalled"):
                self.complaints.append(answer["params"])

    def value(self, expression):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in result, result
        return result["result"].get("value")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
