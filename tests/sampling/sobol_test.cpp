#include "core/sampling/pixel_ranges.h"
#include "core/sampling/sample_source.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/sampling/dimensions.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns whether each of the 2^a x 2^b cells of equal area holds exactly one of the points.
bool one_point_in_every_cell(const std::vector<Vec2>& points, int columns, int rows) {
    std::set<std::pair<int, int>> cells;
    for (const Vec2& p : points) {
        cells.emplace(static_cast<int>(p.x * columns), static_cast<int>(p.y * rows));
    }
    return cells.size() == points.size();
}

std::vector<Vec2> first_points(std::uint32_t count, std::uint32_t seed) {
    std::vector<Vec2> points;
    for (std::uint32_t i = 0; i < count; ++i) points.push_back(ScrambledSobol(seed)(i));
    return points;
}

}  // namespace

TEST_CASE("Scrambled Sobol' points are a (0,2)-sequence", "[sampling]") {
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        const std::vector<Vec2> points = first_points(64, seed);
        for (int a = 0; a <= 6; ++a) {
            INFO("seed " << seed << ", " << (1 << a) << " columns");
            CHECK(one_point_in_every_cell(points, 1 << a, 64 >> a));
        }
    }
}

TEST_CASE("A point is the same on every machine, to the last of its 32 bits", "[sampling]") {
    // Computed independently of this code, bit by bit and with Pascal's triangle, from the same
    // papers.
    CHECK(0x1p32 * ScrambledSobol(1)(7) == Vec2(1389075229, 540007389));
    CHECK(0x1p32 * ScrambledSobol(0)(0) == Vec2(995850218, 1851027888));
    CHECK(0x1p32 * ScrambledSobol(12345)(4294967295U) == Vec2(815730508, 488644200));
}

TEST_CASE("Different seeds give different points, equal names the same", "[sampling]") {
    CHECK(ScrambledSobol(1)(7) != ScrambledSobol(2)(7));
    const SampleSource a({3, 4, 0}, 5), b({3, 4, 0}, 5), other_pixel({4, 3, 0}, 5),
        other_seed({3, 4, 1}, 5);
    CHECK(a.point(9) == b.point(9));
    CHECK(a.point(9) != a.point(10));
    CHECK(a.point(9) != other_pixel.point(9));
    CHECK(a.point(9) != other_seed.point(9));
}

TEST_CASE("Parts of a dimension over all samples make one well distributed set", "[sampling]") {
    std::vector<Vec2> points;
    for (std::uint32_t sample = 0; sample < 16; ++sample) {
        for (std::uint32_t k = 0; k < 4; ++k) {
            points.push_back(SampleSource({1, 2, 3}, sample).stratified(7, k, 4));
        }
    }
    CHECK(one_point_in_every_cell(points, 8, 8));
}

TEST_CASE("Random points are even, and each one is apart from all others", "[sampling]") {
    constexpr std::uint32_t count = 1 << 14;
    std::vector<int> cells(64, 0);
    double products = 0;
    Vec2 last(0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 p = SampleSource({1, 2, 3, Sampler::random}, i).point(7);
        ++cells[static_cast<std::size_t>(p.x * 8) * 8 + static_cast<std::size_t>(p.y * 8)];
        products += (p.x - 0.5) * (last.x - 0.5) + (p.x - 0.5) * (p.y - 0.5);
        last = p;
    }
    double chi_squared = 0;
    for (const int n : cells) chi_squared += (n - 256.0) * (n - 256.0) / 256.0;
    CHECK(chi_squared > 30);  // 63 degrees of freedom: mean 63, standard deviation 11
    CHECK(chi_squared < 120);
    CHECK(std::abs(products / count) < 5 * std::sqrt(2.0 / count) / 12);
}

TEST_CASE("The mean over many seeds is unbiased", "[sampling]") {
    Vec2 sum(0);
    constexpr int seeds = 4096;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) sum += ScrambledSobol(seed)(0);
    // Standard deviation of the mean: 1 / sqrt(12 * 4096) = 0.0045; five of them.
    CHECK(sum.x / seeds == Approx(0.5).margin(0.0225));
    CHECK(sum.y / seeds == Approx(0.5).margin(0.0225));
}

TEST_CASE("Points made together are those made one by one", "[sampling]") {
    for_each_target([] {
        for (const Sampler sampler : {Sampler::sobol, Sampler::random}) {
            SeededPoints batch;
            for (const std::uint32_t count : {1U, 7U, 8U, 9U, 100U}) {
                std::vector<Vec2> expected;
                for (std::uint32_t i = 0; i < count; ++i) {
                    const PixelSamples pixel(static_cast<int>(i), 3, 5, sampler);
                    const std::uint32_t index = hash(i, count);
                    expected.push_back(pixel.points(i % 3)(index));
                    batch.add(pixel.seed(i % 3), index);
                }
                CHECK(std::ranges::equal(batch.make(sampler), expected));
                batch.clear();
            }
        }
    });
}

TEST_CASE("Choices at many vertices named together are those of each sample", "[sampling]") {
    for_each_target([] {
        for (const Sampler sampler : {Sampler::sobol, Sampler::random}) {
            VertexNames vertices;
            SeededPoints points;
            for (const std::uint32_t count : {0U, 1U, 15U, 16U, 17U, 100U}) {
                const std::uint32_t light = count % 3, k = count % 4, parts = 4;
                std::vector<Vec2> expected;
                vertices.clear();
                for (std::uint32_t i = 0; i < count; ++i) {
                    const std::uint32_t ray = hash(i, count), index = hash(ray, 1);
                    const PixelSamples pixel(static_cast<int>(i), 3, 5, sampler);
                    const SampleSource source(pixel, index);
                    expected.push_back(source.stratified(light_dimension(ray, light), k, parts));
                    source.add_vertex(ray, vertices);
                }
                points.name(vertices, light_choice(light), k, parts);
                CHECK(std::ranges::equal(points.make(sampler), expected));
            }
        }
    });
}

TEST_CASE("Samples of ranges of pixels made together are those made one by one", "[sampling]") {
    for_each_target([] {
        const std::uint64_t seed = GENERATE(5, 0x300000005);
        const Sampler sampler = GENERATE(Sampler::sobol, Sampler::random);
        PixelRanges ranges(seed, sampler);
        for (const std::uint32_t longest : {3U, 50U}) {
            ranges.clear();
            std::vector<Imath::V2i> expected_pixels;
            std::vector<Vec2> expected;
            for (std::uint32_t i = 0; i < 40; ++i) {
                const int x = static_cast<int>(i) - 7;
                const std::uint32_t first = 3 * i, last = first + i % longest;
                ranges.add(x, 9, first, last);
                const PointSet points = PixelSamples(x, 9, seed, sampler).points(lens_dimension);
                for (std::uint32_t k = first; k < last; ++k) {
                    expected_pixels.emplace_back(x, 9);
                    expected.push_back(points(k));
                }
            }
            std::vector<SampleSource> sources;
            std::vector<Vec2> points, alone;
            REQUIRE(ranges.samples() == expected.size());
            ranges.name();
            ranges.list(sources);
            std::vector<Imath::V2i> pixels;
            for (const PixelRun& run : ranges.runs()) {
                REQUIRE(run.first == pixels.size());
                pixels.insert(pixels.end(), run.size(), run.pixel);
            }
            ranges.make_points(lens_dimension, points);
            for (const SampleSource& source : sources)
                alone.push_back(source.point(lens_dimension));
            CHECK(pixels == expected_pixels);
            CHECK(points == expected);
            CHECK(alone == expected);
        }
    });
}

TEST_CASE("The decisions of vertices are by Sobol' points, each of its own sequence",
          "[sampling]") {
    std::vector<Vec2> expected;  // the same in all targets
    for_each_target([&] {
        std::vector<Vec2> all;
        for (const Decision decision : {Decision::light, Decision::direction}) {
            VertexPoints vertices(decision);
            for (std::uint32_t i = 0; i < 64; ++i) {
                SampleSource({1, 2, 3}, i).add_vertex(4, vertices);
                SampleSource({1, 2, 3}, i).add_vertex(5, vertices);
            }
            vertices.make(Sampler::sobol);
            for (const std::size_t name : {0, 1}) {
                std::vector<Vec2> places, choices;
                for (std::size_t i = name; i < 128; i += 2) {
                    places.push_back(vertices.place(i));
                    choices.push_back(vertices.choices(i));
                }
                for (const std::vector<Vec2>& points : {places, choices}) {
                    CHECK(one_point_in_every_cell(points, 8, 8));
                    CHECK(std::ranges::find(all, points[0]) == all.end());
                    all.insert(all.end(), points.begin(), points.end());
                }
            }
        }
        if (expected.empty()) expected = all;
        CHECK(all == expected);
    });
}

TEST_CASE("Random choices at vertices are apart from each other", "[sampling]") {
    VertexPoints lights(Decision::light), ways(Decision::direction);
    for (VertexPoints* vertices : {&lights, &ways}) {
        for (std::uint32_t i = 0; i < 2; ++i) {
            SampleSource({1, 2, 3, Sampler::random}, i).add_vertex(4, *vertices);
        }
        vertices->make(Sampler::random);
        CHECK(vertices->place(0) != vertices->place(1));
        CHECK(vertices->place(0) != vertices->choices(0));
    }
    CHECK(lights.place(0) != ways.place(0));
    CHECK(lights.choices(0) != ways.choices(0));
}

TEST_CASE("The points of the parts of samples make one set", "[sampling]") {
    VertexPoints parts(Decision::direction), samples(Decision::direction);
    for (std::uint32_t i = 0; i < 32; ++i) {
        SampleSource({1, 2, 3}, i).part(0, 2).add_vertex(4, parts);
        SampleSource({1, 2, 3}, i).part(1, 2).add_vertex(4, parts);
        SampleSource({1, 2, 3}, 2 * i).add_vertex(4, samples);
        SampleSource({1, 2, 3}, 2 * i + 1).add_vertex(4, samples);
    }
    parts.make(Sampler::sobol);
    samples.make(Sampler::sobol);
    for (std::size_t i = 0; i < 64; ++i) CHECK(parts.place(i) == samples.place(i));
}
