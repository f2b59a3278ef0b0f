#include "bench/hard_cases/rows.h"

namespace etalon::hard {

void Rows::add(const std::string& id, const std::string& variant, const MakeCaseSetup& make,
               Criterion criterion) {
    list_.push_back({id, variant, shape_, criterion, make});
}

void Rows::add_in_float(const std::string& id, const std::string& variant,
                        const MakeCaseSetup& make, Criterion criterion) {
    add(
        id, variant + ", float",
        [make] {
            CaseSetup setup = make();
            setup.ray = [ray = std::move(setup.ray)](Random& random) {
                return in_float(ray(random));
            };
            return setup;
        },
        criterion);
}

void Rows::add_both(const std::string& id, const std::string& variant, const MakeCaseSetup& make,
                    Criterion criterion) {
    add(id, variant, make, criterion);
    add_in_float(id, variant, make, criterion);
}

std::string power_of_ten(int exponent) {
    return "1e" + std::to_string(exponent);
}

std::string power_of_two(int exponent) {
    return "2^" + std::to_string(exponent);
}

}  // namespace etalon::hard
