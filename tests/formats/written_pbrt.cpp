#include "tests/formats/written_pbrt.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "tests/catch.h"

namespace etalon {
namespace {

/// Words, and strings with their quotes.
std::vector<std::string> tokens_of(const std::string& text) {
    std::vector<std::string> tokens;
    std::istringstream in(text);
    for (std::string word; in >> word;) {
        while (word.front() == '"' && (word.size() == 1 || word.back() != '"')) {
            std::string more;
            REQUIRE(in >> more);
            word += " " + more;
        }
        tokens.push_back(word);
    }
    return tokens;
}

std::string unquoted(const std::string& token) {
    return token.substr(1, token.size() - 2);
}

std::vector<Directive> directives_of(const std::string& text) {
    const std::vector<std::string> tokens = tokens_of(text);
    std::vector<Directive> list;
    for (std::size_t i = 0; i < tokens.size();) {
        Directive d{tokens[i++], {}, {}, false, {}};
        REQUIRE(std::isalpha(static_cast<unsigned char>(d.name[0])));
        if (i < tokens.size() && tokens[i][0] == '"') d.type = unquoted(tokens[i++]);
        std::vector<std::string>* values = nullptr;
        for (; i < tokens.size() && !std::isalpha(static_cast<unsigned char>(tokens[i][0])); ++i) {
            const std::string& token = tokens[i];
            if (token == "[" || token == "]") {
                if (!values) d.bracketed = true;
            } else if (token[0] == '"' && token.find(' ') != token.npos) {
                values = &d.values[unquoted(token)];
            } else if (values) {
                values->push_back(token);
            } else {
                d.numbers.push_back(std::stod(token));
            }
        }
        list.push_back(std::move(d));
    }
    return list;
}

void check_parameters(const Directive& d) {
    const std::map<std::string, std::size_t> sizes = {{"point", 3}, {"normal", 3}, {"rgb", 3}};
    for (const auto& [name, values] : d.values) {
        CAPTURE(d.name, d.type, name);
        const std::string type = name.substr(0, name.find(' '));
        CHECK_FALSE(values.empty());
        const bool text = type == "string" || type == "bool";
        if (sizes.contains(type)) CHECK(values.size() % sizes.at(type) == 0);
        if (type == "float" || type == "string" || type == "bool") CHECK(values.size() == 1);
        for (const std::string& v : values) CHECK((v[0] == '"') == text);
    }
    if (d.type != "trianglemesh") return;
    const std::size_t vertices = d.values.at("point P").size() / 3;
    for (const std::string& index : d.values.at("integer indices")) {
        CHECK(std::stoul(index) < vertices);
    }
    if (d.values.contains("normal N")) CHECK(d.values.at("normal N").size() == 3 * vertices);
}

}  // namespace

std::vector<Directive> parsed_strictly(const std::string& text) {
    const std::map<std::string, std::size_t> counts = {
        {"LookAt", 9}, {"Scale", 3}, {"Transform", 16}};
    const std::set<std::string> options = {"LookAt", "Scale",       "Camera",    "Sampler",
                                           "Film",   "PixelFilter", "Integrator"};
    std::vector<Directive> list = directives_of(text);
    std::set<std::string> materials;
    std::vector<std::string> open;
    for (const Directive& d : list) {
        CAPTURE(d.name, d.type);
        CHECK(d.numbers.size() == (counts.contains(d.name) ? counts.at(d.name) : 0));
        CHECK(d.bracketed == (d.name == "Transform"));
        CHECK(options.contains(d.name) == (open.empty() && !d.name.ends_with("Begin")));
        check_parameters(d);
        if (d.name == "MakeNamedMaterial") materials.insert(d.type);
        if (d.name == "NamedMaterial") CHECK(materials.contains(d.type));
        if (d.name.ends_with("Begin")) open.push_back(d.name.substr(0, d.name.size() - 5));
        if (!d.name.ends_with("End")) continue;
        REQUIRE_FALSE(open.empty());
        CHECK(open.back() + "End" == d.name);
        open.pop_back();
    }
    CHECK(open.empty());
    CHECK(list.back().name == "WorldEnd");
    return list;
}

std::vector<Directive> converted(const LoadResult& r) {
    REQUIRE(r.scene);
    return parsed_strictly(write_pbrt(*r.scene, r.settings, "").text);
}

const Directive& find(const std::vector<Directive>& list, const std::string& name) {
    const auto found = std::ranges::find(list, name, &Directive::name);
    REQUIRE(found != list.end());
    return *found;
}

double number(const Directive& d, const std::string& name) {
    REQUIRE(d.values.contains(name));
    return std::stod(d.values.at(name).at(0));
}

Strings names_of(const std::vector<ConversionWarning>& lost) {
    Strings list;
    for (const ConversionWarning& warning : lost) list.push_back(warning.what);
    return list;
}

}  // namespace etalon
