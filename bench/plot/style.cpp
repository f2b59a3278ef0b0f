#include "bench/plot/style.h"

namespace etalon::plot {

/// The colours are those of Okabe & Ito 2008 ("Color Universal Design"), which colour-blind people
/// can distinguish; dashes and labels also work without colours.
std::string_view style() {
    return R"(
.chart{font:12px system-ui,"Segoe UI",Helvetica,Arial,"DejaVu Sans",sans-serif;fill:var(--ink,#1c232b)}
.chart text{font-variant-numeric:tabular-nums}
.chart .paper{fill:#fff}
.chart .heading{font-size:18px;font-weight:bold}
.chart .small{font-size:11px;fill:var(--quiet,#5b6672)}
.chart .strong{font-weight:bold}
.chart .halo{paint-order:stroke;stroke:var(--paper,#fff);stroke-width:3px;stroke-linejoin:round}
.chart line,.chart polyline{fill:none;stroke:var(--ink,#1c232b)}
.chart .grid{stroke:var(--rule,#e6e9ed)}
.chart .tick{stroke:var(--quiet,#5b6672)}
.chart .leader{stroke:var(--edge,#aebac7)}
.chart .frontier{stroke:var(--edge,#aebac7);stroke-width:1.5px}
.chart .curve{stroke-width:2px;stroke-linejoin:round;stroke-linecap:round}
.chart .mark{stroke-width:1.5px}
.chart .band{stroke:none;opacity:.18}
.chart .c1{color:var(--colour-1,#0072b2)}
.chart .c2{color:var(--colour-2,#d55e00)}
.chart .c3{color:var(--colour-3,#007d5b)}
.chart .c4{color:var(--colour-4,#b5588f)}
.chart .c5{color:var(--colour-5,#b27700)}
.chart .c6{color:var(--colour-6,#3d93c8)}
.chart .c7{color:var(--colour-7,#68727d)}
.chart .c2.curve{stroke-dasharray:7 4}
.chart .c3.curve{stroke-dasharray:2 4}
.chart .c4.curve{stroke-dasharray:10 3 2 3}
.chart .c5.curve{stroke-dasharray:12 5}
.chart .c6.curve{stroke-dasharray:5 3}
.chart .c7.curve{stroke-dasharray:1 5}
.chart .curve{stroke:currentColor}
.chart .name,.chart .mark,.chart .band{fill:currentColor}
.chart .mark{stroke:currentColor}
.chart .hollow{fill:var(--paper,#fff)}
)";
}

}  // namespace etalon::plot
