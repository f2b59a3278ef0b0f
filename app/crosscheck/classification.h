// Classification of answers as right or wrong.
#pragma once

#include "app/crosscheck/crosschecked_tracer.h"

namespace etalon::crosscheck {

struct Classification {
    bool decided = true;           ///< false: the oracle cannot tell, and the rest says nothing
    bool wrong_class = false;      ///< a hit where there is none, or none where there is one
    bool wrong_primitive = false;  ///< another one than the nearest
    bool wrong_occlusion = false;  ///< occluded() where there is no hit, or not where there is
    double t_ulp = 0;  ///< error of t in ulp of double, where there is a hit and one was found

    bool right() const { return !wrong_class && !wrong_primitive && !wrong_occlusion; }
};

Classification classify(const OracleAnswer& truth, const Answer& answer);

}  // namespace etalon::crosscheck
