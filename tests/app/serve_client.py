# What `etalon serve` answers, and to whom. Called with the program and the bytes by which its memory may grow
# for one request, in a folder with ball.p3f.
import http.client
import os
import re
import select
import socket
import struct
import subprocess
import sys
import threading
import time

from served import PATIENCE, Served, until

PROGRAM, MOST_GROWTH = sys.argv[1], float(sys.argv[2])
ENDLESS = ("ball.p3f", "-q", "--spp", "16777216", "-o", "a.exr")


def size_of(png):
    assert png[:8] == b"\x89PNG\r\n\x1a\n", png[:8]
    return struct.unpack(">II", png[16:24])


def check_page(served):
    status, headers, body = served.ask()
    page = body.decode()
    assert status == 200 and headers["Content-Type"].startswith("text/html"), (status, headers)
    assert headers["Cache-Control"] == "no-store" and headers["Referrer-Policy"] == "no-referrer"
    assert "default-src 'none'" in headers["Content-Security-Policy"]
    places = set(re.findall(r"https?://[^'\"\s]+", page))
    assert places == {"http://www.w3.org/2000/svg"}, places  # a name, which is never loaded
    assert "prefers-color-scheme:dark" in page


def check_pictures(served):
    until(lambda: served.state()["samples"] > 4)
    for name in ("image.png", "samples.png", "seconds.png"):
        status, headers, body = served.ask(name)
        assert status == 200 and headers["Content-Type"] == "image/png", name
        assert size_of(body) == (32, 24), name
    first = served.ask("image.png")[2]
    until(lambda: served.ask("image.png")[2] != first)  # it converges


def check_state(served):
    state = until(lambda: (s := served.state())["errors"] and s)
    assert state["scene"] == "ball.p3f" and state["stage"] == "rendering"
    assert 0 <= state["part"] <= 1 and state["seconds"] > 0
    more = until(lambda: len(s := served.state()["errors"]) > 2 and s)
    assert more == sorted(more, key=lambda point: point["seconds"])
    assert all(point["relmse"] > 0 for point in more[:1])


def check_refusals(served):
    token = served.path.strip("/")
    for path in ("/", "/" + token, "/" + "0" * 32 + "/", "/" + token[:-1] + "/", "/" + token + "0/",
                 "/x/" + token + "/", "//", "/" + token + "/nothing", "/" + token + "/../"):
        status, _, body = served.ask(path=path)
        assert status == 404, (path, status)
        assert token not in body.decode()
    for host in ("example.org", "example.org:%d" % served.port, "127.0.0.1.example.org", "localhost.",
                 "127.0.0.1:%d.example.org" % served.port):
        status, _, body = served.ask(host=host)
        assert status == 403 and token not in body.decode(), (host, status)
        assert served.ask("stop", method="POST", host=host)[0] == 403
    for host in ("localhost:%d" % served.port, "localhost:9000", "127.0.0.1"):  # by ssh -L
        assert served.ask(host=host)[0] == 200
    assert served.ask("stop")[1]["Allow"] == "POST" and served.ask(method="POST")[1]["Allow"] == "GET"
    assert served.ask("stop")[0] == 405 and served.ask(method="POST")[0] == 405
    status, headers, body = served.ask(method="HEAD")
    assert status == 405 and int(headers["Content-Length"]) > 0 and body == b""
    assert not served.has_ended()


def check_malformed(served):
    for text in (b"\0\0\0\0\r\n\r\n", b"GET / HTTP/1.1\r\n\r\n", b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"GET " + b"a" * 100000 + b"\r\n\r\n",
                 b"POST " + served.path.encode() + b"stop HTTP/1.1\r\nContent-Length: 99999999999\r\n\r\n", b""):
        with socket.create_connection(("127.0.0.1", served.port), PATIENCE) as connection:
            connection.sendall(text)
            connection.shutdown(socket.SHUT_WR)
            try:
                answer = connection.recv(100)
            except ConnectionError:
                answer = b""
            assert not answer.startswith(b"HTTP/1.1 200"), text[:40]
    assert served.ask()[0] == 200


def check_endless(served):
    """A head without an end is refused, and what follows takes no memory."""
    before = served.memory()
    with served.connection() as connection:
        connection.sendall(b"GET / HTTP/1.1\r\n" + b"A: b\r\n" * 10000)
        assert connection.recv(100).startswith(b"HTTP/1.1 431 ")

        def is_closed():
            try:
                connection.sendall(b"A: b\r\n" * 10000)
            except ConnectionError:
                return True

        until(is_closed)
    assert served.memory() < before + MOST_GROWTH, (before, served.memory())


def check_slow(served):
    """The time for a request is limited, whatever arrives meanwhile."""
    start = time.monotonic()
    with served.connection() as connection:
        drip(served, connection)
        assert connection.recv(100).startswith(b"HTTP/1.1 408 ")
    assert 1.9 < time.monotonic() - start < 10


def drip(served, connection):
    """Sends a byte at a time until there is an answer or an end."""
    for byte in b"GET " + served.path.encode() + b" HTTP/1.1\r\n" + b"A: b\r\n" * 1000:
        connection.sendall(bytes([byte]))
        if select.select([connection], [], [], 0.2)[0]:
            return


def check_idle(served):
    """Connections without a request delay no others, and end; at most 64 of them are kept."""
    before = served.open_files()
    idle = [served.connection() for _ in range(100)]
    start = time.monotonic()
    assert served.ask()[0] == 200  # so that all before it have been accepted
    assert served.open_files() < before + 70
    for _ in range(10):
        assert served.ask()[0] == 200
    assert time.monotonic() - start < 5
    for connection in idle:
        try:
            assert connection.recv(100) == b""
        except ConnectionResetError:
            pass
        connection.close()


def check_place(served):
    """Nothing but 127.0.0.1 listens at the port."""
    with open("/proc/net/tcp") as table:
        rows = [line.split() for line in table.readlines()[1:]]
    places = [row[1] for row in rows if row[3] == "0A" and row[1].endswith(":%04X" % served.port)]
    assert places == ["0100007F:%04X" % served.port], places


def check_stop(served):
    assert served.ask("stop", method="POST")[0] == 200
    assert served.end() == 130
    subprocess.run([PROGRAM, "compare", "a.exr", "a.exr"], check=True, stdout=subprocess.DEVNULL)


with Served(PROGRAM, *ENDLESS) as served:
    for check in (check_page, check_pictures, check_state, check_refusals, check_malformed, check_endless, check_slow, check_idle,
                  check_place, check_stop):
        check(served)

# A page that is open has the finished image before the program ends.
with Served(PROGRAM, "ball.p3f", "-q", "--spp", "4", "-o", "b.exr", "-o", "b.png", "--stay") as served:
    until(lambda: served.state()["stage"] == "over")
    assert served.state()["samples"] == 4
    with open("shown.png", "wb") as file:
        file.write(served.ask("image.png")[2])
    served.interrupt()
    assert served.end() == 0
subprocess.run([PROGRAM, "compare", "shown.png", "b.png", "--fail-above", "different_pixels=0"], check=True,
               stdout=subprocess.DEVNULL)

# Its button ends the rendering, and a page that is to stay remains until a signal.
with Served(PROGRAM, *ENDLESS[:-1], "d.exr", "--stay") as served:
    until(lambda: served.state()["samples"] > 0)
    assert served.ask("stop", method="POST")[0] == 200
    until(lambda: served.state()["stage"] == "over")
    time.sleep(0.2)
    assert served.ask("image.png")[0] == 200
    served.interrupt()
    assert served.end() == 130

# What ends without a file says so; a page that is to stay keeps the image that could not be written.
with open("many.p3f", "w") as file:
    with open("ball.p3f") as ball:
        file.write(ball.read())
    file.writelines("s %d 0 -9 0.1\n" % x for x in range(300000))  # so that there is time to stop it
with Served(PROGRAM, "many.p3f", "-q", "-o", "none.exr", "--stay") as served:
    assert served.ask("stop", method="POST")[0] == 200
    until(lambda: served.state()["stage"] == "unwritten")
    assert served.state()["samples"] == 0 and not os.path.exists("none.exr")
    served.interrupt()
    assert served.end() == 130
os.mkdir("gone")
with Served(PROGRAM, *ENDLESS[:-1], "gone/a.exr", "--stay") as served:
    until(lambda: served.state()["samples"] > 0)
    os.rmdir("gone")
    assert served.ask("stop", method="POST")[0] == 200
    until(lambda: served.state()["stage"] == "unwritten")
    assert size_of(served.ask("image.png")[2]) == (32, 24)
    served.interrupt()
    assert served.end() == 130

# Clients that are slow or ask again and again do not keep the program from ending.
with Served(PROGRAM, "ball.p3f", "-q", "--spp", "4", "-o", "c.exr") as served:
    def bother(client):
        try:
            while True:
                client()
        except OSError:  # the program has ended
            pass

    def ask_slowly():
        with served.connection() as connection:
            drip(served, connection)

    clients = [threading.Thread(target=bother, args=(client,))
               for client in (served.ask, ask_slowly, ask_slowly)]
    for client in clients:
        client.start()
    until(lambda: os.path.exists("c.exr"))
    start = time.monotonic()
    assert served.end() == 0
    assert time.monotonic() - start < 5 + 2  # seconds for a busy machine
    for client in clients:
        client.join()

# Two programs at a time have their own ports and tokens.
with Served(PROGRAM, *ENDLESS) as one, Served(PROGRAM, *ENDLESS) as other:
    assert one.port != other.port and one.path != other.path
    assert other.ask(path=one.path)[0] == 404
