# What `etalon serve` answers, and to whom. Called with the program, in a folder with ball.p3f.
import http.client
import re
import socket
import struct
import subprocess
import sys

from served import PATIENCE, Served, until

PROGRAM = sys.argv[1]
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
    for host in ("example.org", "example.org:%d" % served.port, "127.0.0.1", "127.0.0.1:1", "localhost.",
                 "127.0.0.1:%d.example.org" % served.port):
        status, _, body = served.ask(host=host)
        assert status == 403 and token not in body.decode(), (host, status)
        assert served.ask("stop", method="POST", host=host)[0] == 403
    assert served.ask(host="localhost:%d" % served.port)[0] == 200
    assert served.ask("stop")[0] == 405 and served.ask(method="POST")[0] == 405
    assert not served.has_ended()


def check_malformed(served):
    for text in (b"\0\0\0\0\r\n\r\n", b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"GET " + b"a" * 100000 + b"\r\n\r\n",
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
    for check in (check_page, check_pictures, check_state, check_refusals, check_malformed, check_place, check_stop):
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

# Two programs at a time have their own ports and tokens.
with Served(PROGRAM, *ENDLESS) as one, Served(PROGRAM, *ENDLESS) as other:
    assert one.port != other.port and one.path != other.path
    assert other.ask(path=one.path)[0] == 404
