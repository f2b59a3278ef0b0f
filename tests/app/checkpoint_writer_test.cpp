// When checkpoints are due, by a clock of the test.
#include "app/render/checkpoint.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

double now = 0;

double told_seconds() {
    return now;
}

/// Writes a checkpoint, which takes so long.
void keep_for(CheckpointWriter& writer, double seconds) {
    writer.keep([&](StateWriter&) { now += seconds; });
}

void check_due_at(CheckpointWriter& writer, double time) {
    now = time - 0.125;
    CHECK_FALSE(writer.is_due());
    now = time;
    CHECK(writer.is_due());
}

}  // namespace

TEST_CASE("Checkpoints that are written fast are due at regular intervals", "[app]") {
    const Folder f;
    now = 100;
    CheckpointWriter writer(f.path("c"), 64, {}, told_seconds);
    check_due_at(writer, 164);
    keep_for(writer, 0.5);
    check_due_at(writer, 164.5 + 64);
    keep_for(writer, 0.5);
    CHECK(writer.written() == 2);
    CHECK(writer.seconds() == 1);
}

TEST_CASE("Checkpoints take at most a fiftieth of the time", "[app]") {
    const Folder f;
    now = 100;
    CheckpointWriter writer(f.path("c"), 1, {}, told_seconds);
    check_due_at(writer, 101);
    keep_for(writer, 2);
    check_due_at(writer, 103 + 49 * 2);
    keep_for(writer, 0.25);
    check_due_at(writer, 201.25 + 49 * 0.25);
}

TEST_CASE("The time that threads wait for a checkpoint counts as its time", "[app]") {
    const Folder f;
    now = 100;
    CheckpointWriter writer(f.path("c"), 1, {}, told_seconds);
    check_due_at(writer, 101);
    now = 103;
    CHECK(writer.is_due());
    keep_for(writer, 1);
    CHECK(writer.seconds() == 3);
    check_due_at(writer, 104 + 49 * 3);
}

TEST_CASE("A checkpoint that was not written is due again later", "[app]") {
    const Folder f;
    now = 100;
    CheckpointWriter writer(f.path("no/folder/c"), 8, {}, told_seconds);
    check_due_at(writer, 108);
    keep_for(writer, 0);
    CHECK(writer.written() == 0);
    check_due_at(writer, 116);
}
