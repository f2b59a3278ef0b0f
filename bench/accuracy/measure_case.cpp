#include "bench/accuracy/measure_case.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>

#include "app/common/backends.h"
#include "bench/accuracy/spawned_rays.h"
#include "bench/accuracy/timed_tracers.h"
#include "bench/statistics/statistics.h"
#include "core/parallel/parallel.h"

namespace etalon::accuracy {
namespace {

/// The seed is a hash of the row's name, so that rows can be added and removed without changing the
/// rays of others.
std::uint64_t seed_of(const hard::HardCase& c) {
    std::uint64_t h = 0xcbf29ce484222325U;  // FNV-1a
    for (const char letter : c.id + '/' + c.variant) {
        h = (h ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    }
    return h;
}

class Measurement {
  public:
    Measurement(const hard::HardCase& hard_case, const std::vector<const Backend*>& backends,
                const Budget& budget)
        : case_(hard_case),
          setup_(hard_case.make()),
          oracle_(setup_.scene.geometry),
          seed_(seed_of(hard_case)),
          budget_(budget),
          tracers_(case_, setup_, backends, budget),
          results_(tracers_.size()) {
        if (case_.criterion != hard::Criterion::spawned) return;
        spawner_ = backend_tracer(*find_backend(default_backend), setup_.scene);
    }

    /// Returns no rows if no tracer has kernels for the case.
    std::vector<Row> run() {
        if (tracers_.size() == 0) return {};
        const std::uint64_t blocks = (budget_.rays + block_size - 1) / block_size;
        parallel_for(blocks, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t block = begin; block < end; ++block) {
                const bool is_cut = block > 0 && is_over();
                if (is_cut) partial_ = true;
                if (!is_cut) measure_block(block);
            }
        });
        return rows();
    }

  private:
    bool is_over() const {
        if (budget_.stop != nullptr && *budget_.stop) return true;
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        return spent.count() > budget_.seconds;
    }

    /// Measures one block and adds its results to the total.
    void measure_block(std::uint64_t number) {
        const std::uint64_t first = number * block_size;
        const std::uint64_t end = std::min(first + block_size, budget_.rays);
        std::vector<Ray> rays;
        for (std::uint64_t i = first; i < end; ++i) {
            Random random(seed_, i);
            rays.push_back(setup_.ray(random));
        }
        std::vector<TracerResult> results(tracers_.size());
        if (case_.criterion == hard::Criterion::spawned) {
            measure_spawned(RayBlock(std::move(rays)), number, results);
        } else {
            measure_aimed(RayBlock(std::move(rays)), number, results);
        }
        const std::lock_guard lock(mutex_);
        for (std::size_t k = 0; k < results.size(); ++k) results_[k] += results[k];
    }

    void measure_aimed(const RayBlock& block, std::uint64_t number,
                       std::vector<TracerResult>& results) const {
        const auto answers = tracers_.trace(block, number, results);
        const std::vector<OracleReference> references = references_of(block);
        std::optional<ErrorStats> shared;  // shared by all tracers with the same bits
        for (std::size_t k = 0; k < tracers_.size(); ++k) {
            if (answers[k].empty()) continue;
            const bool same = tracers_[k].exact && results[k].stats.deviations == 0;
            const ErrorStats stats =
                same && shared ? *shared : classify(tracers_[k], references, answers[k]);
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

    /// Rays leave the hits of an exact backend, so that they are the same whatever is measured.
    void measure_spawned(const RayBlock& block, std::uint64_t number,
                         std::vector<TracerResult>& results) const {
        std::vector<Answer> hits(block.rays.size(), missed);
        spawner_->closest(block, hits);
        std::vector<Spawned> spawned;
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            Random random(~seed_, number * block_size + i);
            if (const auto s = spawn(setup_, block.rays[i], hits[i], random)) {
                spawned.push_back(*s);
                rays.push_back(s->ray);
            }
        }
        if (rays.empty()) return;
        const auto answers = tracers_.trace(RayBlock(std::move(rays)), number, results);
        for (std::size_t k = 0; k < tracers_.size(); ++k) {
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
        for (std::size_t k = 0; k < tracers_.size(); ++k) {
            const TracerEntry& e = tracers_[k];
            const double ns = statistics::median(results_[k].nanoseconds);
            if (unit == 0 && !e.refined) unit = ns;
            rows.push_back({case_.id, case_.variant, case_.shape,
                            criteria[static_cast<int>(case_.criterion)], e.tracer->name(), e.exact,
                            results_[k].stats, ns});
        }
        const std::uint64_t all = planned_rays();
        for (Row& row : rows) {
            row.cost = unit > 0 ? row.nanoseconds / unit : 0;
            row.partial = partial_ || row.stats.rays < all;
        }
        return rows;
    }

    /// Returns the number of rays that a tracer gets which tests few primitives. Of spawned rays
    /// only as many are known as there were hits to leave.
    std::uint64_t planned_rays() const {
        if (case_.criterion != hard::Criterion::spawned) return budget_.rays;
        std::uint64_t most = 0;
        for (const TracerResult& result : results_) most = std::max(most, result.stats.rays);
        return most;
    }

    const hard::HardCase& case_;
    const hard::CaseSetup setup_;
    const Oracle oracle_;
    const std::uint64_t seed_;
    const Budget budget_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const TimedTracers tracers_;
    std::unique_ptr<Tracer> spawner_;  ///< only for spawned rays
    std::mutex mutex_;
    std::atomic<bool> partial_ = false;  ///< blocks were left out, for all tracers
    std::vector<TracerResult> results_;
};

}  // namespace

std::vector<Row> measure(const hard::HardCase& hard_case,
                         const std::vector<const Backend*>& backends, const Budget& budget) {
    return Measurement(hard_case, backends, budget).run();
}

}  // namespace etalon::accuracy
