#include "bench/accuracy/measure_case.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <mutex>
#include <optional>

#include "bench/accuracy/oracle_reference.h"
#include "core/intersect/backend_roles.h"
#include "core/parallel/parallel.h"

namespace etalon::accuracy {
namespace {

constexpr std::uint64_t block_size = 4096;
constexpr std::uint64_t occlusion_every = 4;  ///< one block in so many also tests occlusion

double thread_cpu_seconds() {
    timespec t = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The seed is a hash of the row's name, so that rows can be added and removed without changing the
/// rays of others.
std::uint64_t seed_of(const hard::HardCase& c) {
    std::uint64_t h = 0xcbf29ce484222325U;  // FNV-1a
    for (const char letter : c.id + '/' + c.variant) {
        h = (h ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    }
    return h;
}

/// Measurements of one tracer over some blocks.
struct Result {
    ErrorStats stats;
    std::vector<double> nanoseconds;  ///< per ray, one value for each block

    Result& operator+=(const Result& other) {
        stats += other.stats;
        nanoseconds.insert(nanoseconds.end(), other.nanoseconds.begin(), other.nanoseconds.end());
        return *this;
    }
};

class Measurement {
  public:
    Measurement(const hard::HardCase& hard_case, const std::vector<const Backend*>& backends,
                const Budget& budget)
        : case_(hard_case),
          setup_(hard_case.make()),
          oracle_(setup_.scene.geometry),
          seed_(seed_of(hard_case)),
          budget_(budget) {
        for (const Backend* b : backends) {
            if (b->has_own_kernels && !b->has_own_kernels(setup_.scene.geometry)) continue;
            enter(backend_tracer(*b, setup_.scene), b->exact, true);
        }
        if (!budget.textbooks) return;
        if (auto kernel = kernel_tracer(setup_.scene)) enter(std::move(kernel), true, true);
        if (case_.criterion != hard::Criterion::oracle) return;
        for (auto& textbook : textbook_tracers(setup_.scene)) {
            enter(std::move(textbook), false, false);
        }
    }

    std::vector<Row> run() {
        results_.resize(entries_.size());
        const std::uint64_t blocks = (budget_.rays + block_size - 1) / block_size;
        parallel_for(blocks, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t block = begin; block < end; ++block) {
                const bool is_cut = block > 0 && is_over();
                if (is_cut) partial_ = true;
                if (!is_cut) shoot(block);
            }
        });
        return rows();
    }

  private:
    void enter(std::unique_ptr<Tracer> tracer, bool exact, bool refined) {
        entries_.push_back({std::move(tracer), exact, refined});
    }

    bool is_over() const {
        if (budget_.stop != nullptr && *budget_.stop) return true;
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        return spent.count() > budget_.seconds;
    }

    bool takes_part(const TracerEntry& entry, std::uint64_t first_ray) const {
        const std::uint64_t all = first_ray * setup_.scene.geometry.item_count();
        return entry.tracer->name() != reference_backend || all < budget_.tests;
    }

    /// Measures one block and adds its results to the total.
    void shoot(std::uint64_t number) {
        const std::uint64_t first = number * block_size;
        const std::uint64_t end = std::min(first + block_size, budget_.rays);
        std::vector<Ray> rays;
        for (std::uint64_t i = first; i < end; ++i) {
            Random random(seed_, i);
            rays.push_back(setup_.ray(random));
        }
        std::vector<Result> results(entries_.size());
        if (case_.criterion == hard::Criterion::spawned) {
            shoot_spawned(RayBlock(std::move(rays)), first, results);
        } else {
            shoot_at(RayBlock(std::move(rays)), first, results);
        }
        const std::lock_guard lock(mutex_);
        for (std::size_t k = 0; k < results.size(); ++k) results_[k] += results[k];
    }

    /// Alternates between the first and the last tracer as the first to run, so that drift affects
    /// all equally.
    std::vector<std::vector<Answer>> ask_all(const RayBlock& block, std::uint64_t first,
                                             std::vector<Result>& results) const {
        const std::size_t count = entries_.size();
        std::vector<std::vector<Answer>> answers(count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t k = first / block_size % 2 == 0 ? i : count - 1 - i;
            if (!takes_part(entries_[k], first)) continue;
            answers[k].resize(block.rays.size(), missed);
            const double start = thread_cpu_seconds();
            entries_[k].tracer->closest(block, answers[k]);
            const double seconds = thread_cpu_seconds() - start;
            const auto rays = static_cast<double>(block.rays.size());
            results[k].nanoseconds.push_back(1e9 * seconds / rays);
            if (first / block_size % occlusion_every != 0) continue;
            count_contradictions(entries_[k], block, answers[k], results[k].stats);
        }
        count_deviations(answers, results);
        return answers;
    }

    void count_contradictions(const TracerEntry& entry, const RayBlock& block,
                              const std::vector<Answer>& answers, ErrorStats& stats) const {
        if (!entry.refined) return;  // a textbook kernel returns only t
        std::vector<char> occluded(answers.size());
        entry.tracer->occluded(block, occluded);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const bool hit = answers[i].primitive != no_index;
            stats.contradictions += hit != (occluded[i] != 0);
        }
    }

    void count_deviations(const std::vector<std::vector<Answer>>& answers,
                          std::vector<Result>& results) const {
        std::optional<std::size_t> first;
        for (std::size_t k = 0; k < entries_.size(); ++k) {
            if (!entries_[k].exact || answers[k].empty()) continue;
            if (!first) first = k;
            for (std::size_t i = 0; i < answers[k].size(); ++i) {
                const Answer &a = answers[k][i], &b = answers[*first][i];
                results[k].stats.deviations +=
                    a.primitive != b.primitive || a.instance != b.instance || a.t != b.t;
            }
        }
    }

    void shoot_at(const RayBlock& block, std::uint64_t first, std::vector<Result>& results) const {
        const auto answers = ask_all(block, first, results);
        const std::vector<OracleReference> references = references_of(block);
        std::optional<ErrorStats> shared;  // shared by all tracers with the same bits
        for (std::size_t k = 0; k < entries_.size(); ++k) {
            if (answers[k].empty()) continue;
            const bool same = entries_[k].exact && results[k].stats.deviations == 0;
            const ErrorStats stats =
                same && shared ? *shared : classify(entries_[k], references, answers[k]);
            if (same) shared = stats;
            results[k].stats += stats;
        }
    }

    std::vector<OracleReference> references_of(const RayBlock& block) const {
        std::vector<OracleReference> references;
        if (case_.criterion != hard::Criterion::oracle) return references;
        for (const Ray& ray : block.rays) references.emplace_back(setup_, oracle_, ray);
        return references;
    }

    ErrorStats classify(const TracerEntry& entry, const std::vector<OracleReference>& references,
                        const std::vector<Answer>& answers) const {
        ErrorStats stats;
        for (std::size_t i = 0; i < references.size(); ++i)
            references[i].classify(entry, answers[i], stats);
        if (!references.empty()) return stats;
        stats.rays = answers.size();
        for (const Answer& a : answers) stats.leaks += a.primitive == no_index;
        return stats;
    }

    /// Uses the hits of the first tracer, since all exact ones find the same.
    void shoot_spawned(const RayBlock& block, std::uint64_t first,
                       std::vector<Result>& results) const {
        std::vector<Answer> hits(block.rays.size(), missed);
        entries_.front().tracer->closest(block, hits);
        std::vector<Spawned> spawned;
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            Random random(~seed_, first + i);
            if (const auto s = spawn(setup_, block.rays[i], hits[i], random)) {
                spawned.push_back(*s);
                rays.push_back(s->ray);
            }
        }
        if (rays.empty()) return;
        const auto answers = ask_all(RayBlock(std::move(rays)), first, results);
        for (std::size_t k = 0; k < entries_.size(); ++k) {
            for (std::size_t i = 0; i < answers[k].size(); ++i) {
                ErrorStats& stats = results[k].stats;
                ++stats.rays;
                stats.self_hits += is_self_hit(setup_.scene, spawned[i], answers[k][i]);
                stats.shift.add(spawned[i].shift);
            }
        }
    }

    std::vector<Row> rows() {
        constexpr const char* criteria[] = {"oracle", "enclosed", "spawned"};
        std::vector<Row> rows;
        double unit = 0;  // unit of cost: the time of the first textbook kernel
        for (std::size_t k = 0; k < entries_.size(); ++k) {
            const TracerEntry& e = entries_[k];
            const double ns = median(std::move(results_[k].nanoseconds));
            if (unit == 0 && !e.refined) unit = ns;
            rows.push_back({case_.id, case_.variant, case_.shape,
                            criteria[static_cast<int>(case_.criterion)], e.tracer->name(), e.exact,
                            results_[k].stats, ns, 0, partial_});
        }
        for (Row& row : rows) row.cost = unit > 0 ? row.nanoseconds / unit : 0;
        return rows;
    }

    const hard::HardCase& case_;
    const hard::CaseSetup setup_;
    const Oracle oracle_;
    const std::uint64_t seed_;
    const Budget budget_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::vector<TracerEntry> entries_;
    std::mutex mutex_;
    std::atomic<bool> partial_ = false;  ///< blocks were left out
    std::vector<Result> results_;
};

}  // namespace

std::vector<Row> measure(const hard::HardCase& hard_case,
                         const std::vector<const Backend*>& backends, const Budget& budget) {
    return Measurement(hard_case, backends, budget).run();
}

}  // namespace etalon::accuracy
