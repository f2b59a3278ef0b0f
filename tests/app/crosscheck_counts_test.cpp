// Counts of crosscheck for made-up answers, and the partial counts after an interruption.
#include "app/crosscheck/crosscheck_results.h"
#include "core/formats/load.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::crosscheck;
using etalon::test::Folder;
using etalon::test::small_scene;

namespace {

OracleAnswer hit_at(double t, std::vector<HitKey> tied) {
    OracleAnswer truth;
    truth.kind = OracleAnswer::hit;
    truth.t = t;
    truth.exact_t = t;
    truth.primitive = static_cast<std::uint32_t>(tied.front());
    truth.tied = std::move(tied);
    return truth;
}

OracleAnswer undecidable() {
    OracleAnswer truth;
    truth.kind = OracleAnswer::undecidable;
    return truth;
}

const Answer nothing;
const Answer ball_at_2{Hit{2, 7}, true};

CrosscheckedTracer tracer(const std::string& name, std::vector<Answer> answers) {
    return {name, false, {Answers{std::move(answers)}}};
}

/// Classifies the answer to a ray along x in a scene of size 1.
Classification classify(const OracleAnswer& truth, const Answer& answer, bool exact = true) {
    return crosscheck::classify({"aimed", {Ray{Vec3(0), {1, 0, 0}}}, {truth}}, 0, answer, exact);
}

Scene eight_balls() {
    Scene scene;
    for (int i = 0; i < 8; ++i) scene.geometry.add(Sphere{Vec3(0), 1}, 0);
    return scene;
}

}  // namespace

TEST_CASE("An answer is classified by class, primitive, occlusion and distance", "[crosscheck]") {
    const OracleAnswer truth = hit_at(2, {5, 7});
    CHECK(classify(truth, ball_at_2).right());
    CHECK(classify(truth, {Hit{2 + 0x1p-50, 5}, true}).t_ulp == 2);
    CHECK(classify(truth, {Hit{2, 6}, true}).wrong_primitive);
    CHECK(classify(truth, {Hit{2, 7}, false}).wrong_occlusion);
    CHECK(classify(truth, nothing).wrong_class);
    CHECK(classify(OracleAnswer{}, ball_at_2).wrong_class);
    CHECK(classify(OracleAnswer{}, nothing).right());
    CHECK_FALSE(classify(undecidable(), ball_at_2).decided);
}

TEST_CASE("An exact backend's t is right to the tolerance, at a tie to that of the others too",
          "[crosscheck]") {
    const auto is_wrong = [](const OracleAnswer& truth, double t) {
        return classify(truth, {Hit{t, 7}, true}).wrong_t;
    };
    const OracleAnswer alone = hit_at(2, {7}), tied = hit_at(2, {5, 7});
    CHECK_FALSE(is_wrong(alone, 2 * (1 + t_tolerance)));
    CHECK(is_wrong(alone, 2 * (1 + 2 * t_tolerance)));
    CHECK_FALSE(is_wrong(tied, 2 * (1 - 3 * t_tolerance)));
    CHECK(is_wrong(tied, 2 * (1 - 4 * t_tolerance)));
    CHECK_FALSE(classify(alone, {Hit{3, 7}, true}).right());
    CHECK_FALSE(is_wrong(hit_at(1e-320, {7}), 1.1e-320));
}

TEST_CASE("Another backend's t is wrong if it is off by a hundredth of the scene's size",
          "[crosscheck]") {
    const auto is_wrong = [](double truth, double t) {
        return classify(hit_at(truth, {7}), {Hit{t, 7}, true}, false).wrong_t;
    };
    CHECK_FALSE(is_wrong(1e-7, 0.005));
    CHECK(is_wrong(1e-7, 0.02));
    CHECK_FALSE(is_wrong(0x1p40, 0x1p40 + 0x1p16));  // an ulp of a float
    CHECK(is_wrong(0x1p40, 0x1p40 + 0x1p18));
}

TEST_CASE("A hit on another primitive is not also one at a wrong distance", "[crosscheck]") {
    const Classification v = classify(hit_at(2, {7}), {Hit{3, 6}, true});
    CHECK(v.wrong_primitive);
    CHECK_FALSE(v.wrong_t);
}

TEST_CASE("The counts leave out undecidable rays and order the errors of t", "[crosscheck]") {
    const Trial trial{"aimed",
                      std::vector<Ray>(5),
                      {hit_at(2, {7}), hit_at(2, {7}), hit_at(2, {7}), undecidable(), {}}};
    const Answers answers{{{Hit{2 + 0x1p-49, 7}, true}, ball_at_2, nothing, ball_at_2, nothing}};
    const CrosscheckCounts t = counts_of(trial, answers, true);
    CHECK(t.rays == 5);
    CHECK(t.undecidable == 1);
    CHECK(t.class_errors == 1);
    CHECK(t.occlusion_errors == 1);
    CHECK(t.t_quantile(0.5) == 0);
    CHECK(t.t_quantile(1) == 4);
}

TEST_CASE("An exact backend's answers must be those of the others, decidable or not",
          "[crosscheck]") {
    const Trial trial{
        "aimed", std::vector<Ray>(4), {hit_at(2, {5, 7}), {}, undecidable(), undecidable()}};
    const CrosscheckedTracer a = tracer("a", {ball_at_2, nothing, ball_at_2, nothing});
    CrosscheckedTracer b = tracer("b", {{Hit{2, 5}, true}, nothing, {Hit{2, 7}, false}, nothing});
    mark_differences(b, a);
    const CrosscheckCounts t = counts_of(trial, b.answers[0], true);
    CHECK(t.differences == 2);
    CHECK_FALSE(t.clean());
    CHECK(t.class_errors + t.primitive_errors + t.occlusion_errors == 0);
    CHECK(worst_rays(eight_balls(), {trial}, b, 9).size() == 2);
    CHECK(contingency({trial}, a, b).both_right == 2);  // for the oracle both are

    CrosscheckedTracer zero = tracer("zero", {{Hit{0.0, 7}, true}}), negative = zero;
    negative.answers[0].all[0].closest->t = -0.0;
    mark_differences(negative, zero);
    CHECK(negative.answers[0].all[0].differs);
}

TEST_CASE("The sum of tallies is the sum of each of their numbers", "[crosscheck]") {
    const CrosscheckCounts a{1, 2, 4, 8, 12, 16, 32, {0, 4}, 0.5},
        b{100, 200, 400, 800, 1200, 1600, 3200, {2}, 0.25};
    const CrosscheckCounts both = sum({a, b});
    CHECK(both.rays == 101);
    CHECK(both.undecidable == 202);
    CHECK(both.class_errors == 404);
    CHECK(both.primitive_errors == 808);
    CHECK(both.t_errors == 1212);
    CHECK(both.occlusion_errors == 1616);
    CHECK(both.differences == 3232);
    CHECK(both.t_ulp == std::vector<double>{0, 2, 4});
    CHECK(both.seconds == 0.75);
}

TEST_CASE("A contingency table counts decided rays by who is right", "[crosscheck]") {
    const std::vector<Trial> trials = {
        {"aimed", std::vector<Ray>(6), {{}, {}, {}, {}, {}, undecidable()}}};
    const Answer& wrong = ball_at_2;
    const CrosscheckedTracer a = tracer("a", {nothing, nothing, nothing, nothing, wrong, wrong});
    const CrosscheckedTracer b = tracer("b", {nothing, wrong, wrong, wrong, wrong, nothing});
    const Contingency c = contingency(trials, a, b);
    CHECK(c.both_right == 1);
    CHECK(c.only_a_right == 3);
    CHECK(c.only_b_right == 0);
    CHECK(c.both_wrong == 1);
    CHECK(c.mcnemar() == 3);
    CHECK(c.in_words() == "b is wrong where a is right in 3 rays; never the other way round.");
    CHECK(contingencies(trials, {a, b, a}).size() == 3);
    CHECK(contingencies(trials, {a, b, a, b}).size() == 3);
}

TEST_CASE("McNemar's test compares the errors of one and of the other", "[crosscheck]") {
    CHECK(Contingency{"a", "b", 10, 0, 0, 2}.mcnemar() == 0);
    CHECK(Contingency{"a", "b", 10, 2, 14, 0}.mcnemar() == 9);
    CHECK(Contingency{"a", "b", 10, 2, 14, 0}.in_words() ==
          "a is wrong where b is right in 14 rays; the other way round in 2 (chance alone would "
          "rarely do that).");
    CHECK(Contingency{"a", "b", 10, 1, 0, 0}.in_words() ==
          "b is wrong where a is right in 1 ray; never the other way round.");
    CHECK(Contingency{"a", "b", 10, 0, 0, 0}.in_words() ==
          "a and b are never wrong in 10 rays that the oracle decides.");
    const auto may_be_chance = [](std::size_t a, std::size_t b) {
        const std::string text = Contingency{"a", "b", 0, a, b, 0}.in_words();
        return text.find("(chance alone may do that)") != std::string::npos;
    };
    CHECK(may_be_chance(7, 1));  // 18 of 256
    CHECK(may_be_chance(1, 1));
    CHECK_FALSE(may_be_chance(8, 1));  // 20 of 512
    CHECK(may_be_chance(500, 550));
    CHECK_FALSE(may_be_chance(5'000'000, 5'100'000));
    CHECK(Contingency{"a", "b", 10, 0, 0, 2}.in_words() == "a and b are wrong in the same 2 rays.");
}

TEST_CASE("Only a backend that promises to be exact breaks the promise by an error",
          "[crosscheck]") {
    CrosscheckCounts wrong;
    wrong.t_errors = 1;
    CHECK(Results{{}, {{"free", false, {}, wrong, {}}}, {}}.as_promised());
    CHECK_FALSE(Results{{}, {{"exact", true, {}, wrong, {}}}, {}}.as_promised());
}

TEST_CASE("The worst rays come gravest first, the furthest off among equals", "[crosscheck]") {
    const Scene scene = eight_balls();
    const Trial trial{"bounce", std::vector<Ray>(4), std::vector(4, hit_at(2, {7}))};
    const CrosscheckedTracer c =
        tracer("c", {{Hit{2.5, 6}, true}, {Hit{3, 6}, true}, nothing, {Hit{2 + 0x1p-50, 7}, true}});
    const auto worst = worst_rays(scene, {trial}, c, 9);
    REQUIRE(worst.size() == 3);
    CHECK(worst[0].found == "miss");
    CHECK(worst[0].oracle == "hit 2 sphere 7");
    CHECK(worst[1].found == "hit 3 sphere 6");
    CHECK(worst[2].found == "hit 2.5 sphere 6");
    CHECK(worst_rays(scene, {trial}, c, 1).size() == 1);

    const CrosscheckedTracer good = tracer("good", {4, {Hit{2 + 0x1p-50, 7}, true}});
    CHECK(worst_rays(scene, {trial}, good, 9).at(0).wrong == "t off by 2 ulp");
}

TEST_CASE("The line of a shadow ray says that it is one", "[crosscheck]") {
    WorstRay worst{"shadow", "hit not found", "hit", "miss", Ray{Vec3(0), Vec3(1)}};
    CHECK_FALSE(trace_lines(worst).ends_with(" shadow\n"));
    worst.ray.set_shadow();
    CHECK(trace_lines(worst).ends_with(" shadow\n"));
}

TEST_CASE("A stop leaves the rays that the oracle, or the backends that have answered",
          "[crosscheck]") {
    const Folder f;
    const LoadResult loaded = load_scene(f.write("ball.p3f", small_scene), {});
    REQUIRE(loaded.scene.has_value());
    for (const std::string stage : {"none", "oracle", "backends"}) {
        INFO(stage);
        std::atomic<bool> stop = false, outside = false;
        std::string now;
        const CrosscheckProgress run{stop, [&](const std::string& begun) { now = begun; },
                                     [&](double part) {
                                         if (part < 0 || part > 1) outside = true;
                                         if (now == stage) stop = true;
                                     }};
        const Results results =
            crosscheck::crosscheck(*loaded.scene, {32, 24}, {{"bvh", "grid", "none"}, 400, 1}, run);
        CHECK_FALSE(outside);
        CHECK(results.stopped == (stage != "none"));
        CHECK(results.backends.size() == (stage == "backends" ? 1 : 3));
        CHECK(results.kinds.size() == (stage == "oracle" ? 1 : 4));
        CHECK(results.backends[0].total.rays > 0);
        CHECK((results.backends[0].total.rays < 400) == (stage == "oracle"));
    }
}
