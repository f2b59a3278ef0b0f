#include "core/image/oiio_loader.h"

#include "core/base/module_symbol.h"

namespace etalon {
namespace {

Result<const EtalonOiio*> load() {
    const Result<void*> symbol = module_symbol("etalon_oiio.so", "etalon_oiio");
    std::string error = symbol.error;
    if (symbol) {
        const EtalonOiio* table = reinterpret_cast<EtalonOiioEntry>(symbol.value)();
        if (table->version == etalon_oiio_version) return {table, {}};
        error = "etalon_oiio.so belongs to another version of the program";
    }
    return {nullptr, "the OpenImageIO module cannot be loaded: " + error};
}

}  // namespace

const Result<const EtalonOiio*>& load_oiio() {
    static const Result<const EtalonOiio*> module = load();
    return module;
}

}  // namespace etalon
