// The defaults of every parameter, listed independently.
#include <fmt/format.h>

#include <map>
#include <sstream>

#include "core/formats/pbrt/parameters.h"
#include "tests/catch.h"
#include "tests/color/copper.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

struct Expected {
    Category category;
    std::string plugin;
    std::string defaults;  ///< name=default; nothing after the sign if there is none
};

const std::string camera =
    "shutteropen=0 shutterclose=1 lensradius=0 focaldistance=1e6 "
    "frameaspectratio= screenwindow= ";
const std::string mapping = "mapping=uv uscale=1 vscale=1 udelta=0 vdelta=0 v1=1,0,0 v2=0,1,0";
const std::string image_map = "filename= wrap=repeat trilinear=0 maxanisotropy=8 scale=1 gamma= ";
const std::string path = "maxdepth=5 rrthreshold=1 lightsamplestrategy=spatial pixelbounds=";
const std::string mesh = "indices= P= uv= N= S= faceIndices= alpha=1 shadowalpha=1";
const std::string medium = "sigma_a=.0011,.0024,.014 sigma_s=2.55,3.21,3.77 preset= g=0 scale=1 ";
const std::string noise = "octaves=8 roughness=.5";

const std::vector<Expected> all_expected = {
    {Category::camera, "perspective", camera + "fov=90 halffov=-1"},
    {Category::camera, "orthographic", camera},
    {Category::camera, "environment",
     "shutteropen=0 shutterclose=1 lensradius=0 focaldistance=1e30 frameaspectratio= "
     "screenwindow="},
    {Category::camera, "realistic",
     "shutteropen=0 shutterclose=1 lensfile= aperturediameter=1 focusdistance=10 "
     "simpleweighting=1"},
    {Category::sampler, "halton", "pixelsamples=16 samplepixelcenter=0"},
    {Category::sampler, "sobol", "pixelsamples=16"},
    {Category::sampler, "02sequence", "pixelsamples=16 dimensions=4"},
    {Category::sampler, "lowdiscrepancy", "pixelsamples=16 dimensions=4"},
    {Category::sampler, "maxmindist", "pixelsamples=16 dimensions=4"},
    {Category::sampler, "random", "pixelsamples=4"},
    {Category::sampler, "stratified", "jitter=1 xsamples=4 ysamples=4 dimensions=4"},
    {Category::filter, "box", "xwidth=.5 ywidth=.5"},
    {Category::filter, "gaussian", "xwidth=2 ywidth=2 alpha=2"},
    {Category::filter, "mitchell", "xwidth=2 ywidth=2 B=.333333343 C=.333333343"},
    {Category::filter, "sinc", "xwidth=4 ywidth=4 tau=3"},
    {Category::filter, "triangle", "xwidth=2 ywidth=2"},
    {Category::film, "image",
     "xresolution=1280 yresolution=720 cropwindow=0,1,0,1 scale=1 diagonal=35 "
     "maxsampleluminance=inf filename=pbrt.exr"},
    {Category::integrator, "path", path},
    {Category::integrator, "volpath", path},
    {Category::integrator, "directlighting", "strategy=all maxdepth=5 pixelbounds="},
    {Category::integrator, "whitted", "maxdepth=5 pixelbounds="},
    {Category::integrator, "bdpt",
     "maxdepth=5 lightsamplestrategy=power visualizestrategies=0 visualizeweights=0 pixelbounds="},
    {Category::integrator, "mlt",
     "maxdepth=5 bootstrapsamples=100000 chains=1000 mutationsperpixel=100 "
     "largestepprobability=.3 sigma=.01"},
    {Category::integrator, "sppm",
     "iterations=64 maxdepth=5 photonsperiteration=-1 imagewritefrequency=-2147483648 radius=1"},
    {Category::integrator, "ambientocclusion", "cossample=1 nsamples=64 pixelbounds="},
    {Category::accelerator, "bvh", "splitmethod=sah maxnodeprims=4"},
    {Category::accelerator, "kdtree",
     "intersectcost=80 traversalcost=1 emptybonus=.5 maxprims=1 maxdepth=-1"},
    {Category::shape, "sphere", "radius=1 zmin=-1 zmax=1 phimax=360"},
    {Category::shape, "cylinder", "radius=1 zmin=-1 zmax=1 phimax=360"},
    {Category::shape, "disk", "height=0 radius=1 innerradius=0 phimax=360"},
    {Category::shape, "cone", "radius=1 height=1 phimax=360"},
    {Category::shape, "paraboloid", "radius=1 zmin=0 zmax=1 phimax=360"},
    {Category::shape, "hyperboloid", "p1=0,0,0 p2=1,1,1 phimax=360"},
    {Category::shape, "curve",
     "width=1 width0=1 width1=1 type=flat basis=bezier degree=3 P= N= splitdepth=3"},
    {Category::shape, "trianglemesh", mesh},
    {Category::shape, "plymesh", "filename= alpha=1 shadowalpha=1"},
    {Category::shape, "heightfield", "nu= nv= Pz="},
    {Category::shape, "loopsubdiv", "levels=3 indices= P= scheme=loop"},
    {Category::shape, "nurbs", "nu= nv= uorder= vorder= uknots= vknots= u0= u1= v0= v1= P= Pw="},
    {Category::material, "matte", "Kd=.5,.5,.5 sigma=0 bumpmap="},
    {Category::material, "plastic",
     "Kd=.25,.25,.25 Ks=.25,.25,.25 roughness=.1 remaproughness=1 bumpmap="},
    {Category::material, "translucent",
     "Kd=.25,.25,.25 Ks=.25,.25,.25 reflect=.5,.5,.5 transmit=.5,.5,.5 roughness=.1 "
     "remaproughness=1 bumpmap="},
    {Category::material, "glass",
     "Kr=1,1,1 Kt=1,1,1 eta=1.5 uroughness=0 vroughness=0 remaproughness=1 bumpmap="},
    {Category::material, "mirror", "Kr=.9,.9,.9 bumpmap="},
    {Category::material, "metal",
     "eta=.19999,.92209,1.09988 k=3.90464,2.44763,2.13765 roughness=.01 uroughness= "
     "vroughness= remaproughness=1 bumpmap="},
    {Category::material, "substrate",
     "Kd=.5,.5,.5 Ks=.5,.5,.5 uroughness=.1 vroughness=.1 remaproughness=1 bumpmap="},
    {Category::material, "uber",
     "Kd=.25,.25,.25 Ks=.25,.25,.25 Kr=0,0,0 Kt=0,0,0 roughness=.1 uroughness= vroughness= "
     "eta=1.5 opacity=1,1,1 remaproughness=1 bumpmap="},
    {Category::material, "disney",
     "color=.5,.5,.5 metallic=0 eta=1.5 roughness=.5 speculartint=0 anisotropic=0 sheen=0 "
     "sheentint=.5 clearcoat=0 clearcoatgloss=1 spectrans=0 scatterdistance=0,0,0 thin=0 "
     "flatness=0 difftrans=1 bumpmap="},
    {Category::material, "hair",
     "sigma_a= color= eumelanin= pheomelanin= eta=1.55 beta_m=.3 beta_n=.3 alpha=2"},
    {Category::material, "subsurface",
     "name= sigma_a=.0011,.0024,.014 sigma_s=2.55,3.21,3.77 g=0 scale=1 eta=1.33 Kr=1,1,1 "
     "Kt=1,1,1 uroughness=0 vroughness=0 remaproughness=1 bumpmap="},
    {Category::material, "kdsubsurface",
     "Kd=.5,.5,.5 mfp=1,1,1 eta=1.33 g=0 scale=1 Kr=1,1,1 Kt=1,1,1 uroughness=0 vroughness=0 "
     "remaproughness=1 bumpmap="},
    {Category::material, "fourier", "bsdffile= bumpmap="},
    {Category::material, "mix", "namedmaterial1= namedmaterial2= amount=.5,.5,.5"},
    {Category::material, "none", ""},
    {Category::float_texture, "constant", "value=1"},
    {Category::float_texture, "scale", "tex1=1 tex2=1"},
    {Category::float_texture, "mix", "tex1=0 tex2=1 amount=.5"},
    {Category::float_texture, "bilerp", "v00=0 v01=1 v10=0 v11=1 " + mapping},
    {Category::float_texture, "imagemap", image_map + mapping},
    {Category::float_texture, "checkerboard",
     "dimension=2 tex1=1 tex2=0 aamode=closedform " + mapping},
    {Category::float_texture, "dots", "inside=1 outside=0 " + mapping},
    {Category::float_texture, "fbm", noise},
    {Category::float_texture, "wrinkled", noise},
    {Category::float_texture, "windy", ""},
    {Category::float_texture, "ptex", "filename= gamma=2.2"},
    {Category::spectrum_texture, "constant", "value=1,1,1"},
    {Category::spectrum_texture, "scale", "tex1=1,1,1 tex2=1,1,1"},
    {Category::spectrum_texture, "mix", "tex1=0,0,0 tex2=1,1,1 amount=.5"},
    {Category::spectrum_texture, "bilerp", "v00=0,0,0 v01=1,1,1 v10=0,0,0 v11=1,1,1 " + mapping},
    {Category::spectrum_texture, "imagemap", image_map + mapping},
    {Category::spectrum_texture, "uv", mapping},
    {Category::spectrum_texture, "checkerboard",
     "dimension=2 tex1=1,1,1 tex2=0,0,0 aamode=closedform " + mapping},
    {Category::spectrum_texture, "dots", "inside=1,1,1 outside=0,0,0 " + mapping},
    {Category::spectrum_texture, "fbm", noise},
    {Category::spectrum_texture, "wrinkled", noise},
    {Category::spectrum_texture, "windy", ""},
    {Category::spectrum_texture, "marble", noise + " scale=1 variation=.2"},
    {Category::spectrum_texture, "ptex", "filename= gamma=2.2"},
    {Category::light, "point", "I=1,1,1 scale=1,1,1 from=0,0,0"},
    {Category::light, "spot",
     "I=1,1,1 scale=1,1,1 from=0,0,0 to=0,0,1 coneangle=30 conedeltaangle=5"},
    {Category::light, "distant", "L=1,1,1 scale=1,1,1 from=0,0,0 to=0,0,1"},
    {Category::light, "infinite", "L=1,1,1 scale=1,1,1 mapname= samples=1"},
    {Category::light, "exinfinite", "L=1,1,1 scale=1,1,1 mapname= samples=1"},
    {Category::light, "goniometric", "I=1,1,1 scale=1,1,1 mapname="},
    {Category::light, "projection", "I=1,1,1 scale=1,1,1 fov=45 mapname="},
    {Category::area_light, "diffuse", "L=1,1,1 scale=1,1,1 twosided=0 samples=1"},
    {Category::area_light, "area", "L=1,1,1 scale=1,1,1 twosided=0 samples=1"},
    {Category::medium, "homogeneous", medium},
    {Category::medium, "heterogeneous", medium + "nx=1 ny=1 nz=1 p0=0,0,0 p1=1,1,1 density="},
};

using Defaults = std::map<std::string, std::string>;

/// Numbers as text that is the same for all spellings of a float.
std::string normalized(const std::string& text) {
    std::string result;
    std::stringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        char* end = nullptr;
        const float x = std::strtof(part.c_str(), &end);
        result += (result.empty() ? "" : ",") + (*end == 0 ? fmt::format("{}", x) : part);
    }
    return result;
}

Defaults expected_defaults(const std::string& text) {
    Defaults list;
    std::stringstream words(text);
    for (std::string word; words >> word;) {
        const std::size_t equals = word.find('=');
        list[word.substr(0, equals)] = normalized(word.substr(equals + 1));
    }
    return list;
}

std::string default_of(const Parameters& parameters, const ParameterSpec& spec) {
    const bool is_text = spec.type == ValueType::string || spec.type == ValueType::file ||
                         spec.type == ValueType::material;
    if (is_text) return std::string(parameters.string(spec.name));
    if (spec.default_value == Default{}) return {};
    if (spec.type == ValueType::number && spec.length == 0) {
        return fmt::format("{}", parameters.number(spec.name));
    }
    if (spec.type == ValueType::integer || spec.type == ValueType::flag) {
        return normalized(std::to_string(parameters.integer(spec.name)));
    }
    std::string list;
    for (const float x : parameters.numbers(spec.name)) {
        list += (list.empty() ? "" : ",") + fmt::format("{}", x);
    }
    return list;
}

}  // namespace

TEST_CASE("every plugin has the parameters and defaults of pbrt-v3") {
    for (const Expected& expected : all_expected) {
        const PluginType* const type = find_plugin(expected.category, expected.plugin);
        CAPTURE(to_string(expected.category), expected.plugin);
        REQUIRE(type);
        const Parameters parameters(*type);
        Defaults defaults;
        for (const ParameterSpec& spec : type->parameters) {
            defaults[std::string(spec.name)] = default_of(parameters, spec);
            CHECK_FALSE(parameters.is_given(spec.name));
        }
        CHECK(defaults == expected_defaults(expected.defaults));
    }
}

TEST_CASE("no plugin is without a line in the list of defaults") {
    for (std::size_t c = 0; c < category_count; ++c) {
        const auto category = static_cast<Category>(c);
        for (const PluginType& type : plugin_types(category)) {
            CAPTURE(to_string(category), type.name);
            CHECK(type.category == category);
            CHECK(std::ranges::any_of(all_expected, [&](const Expected& e) {
                return find_plugin(e.category, e.plugin) == &type;
            }));
        }
    }
}

TEST_CASE("the default of one parameter may be the value of another") {
    const PluginType& sphere = *find_plugin(Category::shape, "sphere");
    const Parameters parameters(sphere, {{sphere.find("radius"), std::vector{3.0F}}});
    CHECK(parameters.number("zmin") == -3);
    CHECK(parameters.number("zmax") == 3);
}

TEST_CASE("a metal without parameters is copper, in agreement with other measurements") {
    const Parameters metal(*find_plugin(Category::material, "metal"));
    for (int k = 0; k < 3; ++k) {
        CHECK(metal.color("eta")[k] == Approx(copper_eta()[k]).epsilon(0.01));
        CHECK(metal.color("k")[k] == Approx(copper_k()[k]).epsilon(0.01));
    }
}
