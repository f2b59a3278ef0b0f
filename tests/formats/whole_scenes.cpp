#include "tests/formats/whole_scenes.h"

#include "core/numerics/random.h"

namespace etalon {
namespace {

std::string number(Random& random) {
    return std::to_string(static_cast<double>(random.index(1000)) * 1e-3) + " ";
}

/// Both dialects.
std::string p3f_text(const std::string& camera) {
    std::string text =
        "# generated\r\naccel grid\nspp 4\nbclr 0.1 0.2 0.3\nenv nosky\n" + camera +
        "light punctual 1 2 3 1 1 1\nlight quad 4 3 2 1 1 1 4 2 2 3 3 2 16\nl 9 9 9 .5 .5 .5\n"
        "mat 1 1 1 0.5 1 1 1 0 10 0 1\npl 12 12 -0.5 -12 12 -0.5 -12 -12 -0.5\n"
        "npl 0 0 1 3 #floor\nf 0 0.5 0 0 1 1 1 0.2 30.1 1 1.15\nbox 0 0 0 1 1 1.5\n"
        "c 1 2 3 0.5\n3 2 1 0\ns 0 0 0 -9\np 5\n0 0 0\n1 0 0\n1 1 0\n.5 .25 0\n0 1 0\n"
        "pp 3\n0 0 0 0 0 1\n1 0 0 0 0.1 1\n0 1 0 0.1 0 1\n";
    Random random(3);
    for (int i = 0; i < 60; ++i) text += "s " + number(random) + "-1.5e-2 +7. .25\n";
    text += "mesh 40 60\n";
    for (int i = 0; i < 40; ++i) {
        for (int k = 0; k < 3; ++k) text += number(random);
        text += "\n";
    }
    for (int i = 0; i < 60; ++i) {
        const auto v = random.index(38);
        text += std::to_string(v + 1) + " " + std::to_string(v + 2) + " -1\n";
    }
    return text;
}

WholeScene p3f() {
    const std::string camera =
        "camera\neye 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0.01\nresolution 40 30\n"
        "aperture 0\nfocal 1\n";
    return {
        "p3f",
        p3f_text(camera),
        1,  // its skybox does not exist
        127,
        camera,
        "s x\n",
        "v ",
        {"s",        "p",     "pp",         "mat", "f",   "box",   "c",     "mesh",   "pl",
         "npl",      "light", "l",          "v",   "env", "accel", "spp",   "eye",    "at",
         "quad",     "0",     "1",          "-1",  "3",   "4",     "1e308", "-1e308", "1e-308",
         "punctual", "angle", "resolution", "up",  "2",   "sm",    "\n",    "#\n",    "camera"}};
}

WholeScene nff() {
    const std::string camera =
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0\nresolution 40 30\n";
    std::string text = "# generated\r\nb 0.078 0.361 0.753\n" + camera +
                       "l 4 3 2\nl 1 -4 4 1 .5 0\nf 1 0.75 0.33 0.8 0 100000 0 0\n"
                       "p 5\n0 0 0\n1 0 0\n1 1 0\n.5 .25 0\n0 1 0\n"
                       "pp 3\n0 0 0 0 0 1\n1 0 0 0 0.1 1\n0 1 0 0.1 0 1\n"
                       "f 1 0.6 0.4 0.2 0.5 3.0827 0.8 1.1\nc 1 2 3 .5 1 2 4 .25\n"
                       "s 0 0 0 -9\n";
    Random random(3);
    for (int i = 0; i < 100; ++i) text += "s " + number(random) + "-1.5e-2 +7. .25\n";
    return {
        "nff", text, 0, 104, camera, "s x\n", "v ", {"s",          "p",   "pp", "f",      "c",
                                                     "l",          "v",   "b",  "from",   "at",
                                                     "hither",     "0",   "1",  "1e-308", "angle",
                                                     "resolution", "up",  "2",  "\n",     "1e308",
                                                     "-1e308",     "#\n", "3",  "4",      "-1"}};
}

WholeScene prt() {
    const std::string camera = "from 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nresolution 40 30\n";
    std::string text =
        "# generated\r\n" + camera +
        "background .1 .1 .1 n\nlight 3 4.9 3\n"
        "instance pair\nsphere 0 0 0 1\nsurface 1 1 1 .5 0 0 0 0 0 0 .4 0 0 .4 1 1 1 30 0\n"
        "polygon 4\t# top\n0 0 0\n0 5 0\n6 5 0\n6 0 0\nend_instance\n"
        "surface .9 .9 .9 .3  .9 .9 .9 .9  0 0 0  0 0 0 .9 .9 .9 70 1.5\n"
        "hsphere 1 2 3 .5 .1\ninstance_of pair 1 2 3\ninstance_of pair -1 2 3\n"
        "cone\n1 2 3 .5\n1 2 4 .25\nring 0 0 0 1 0 0 0 1 0 2 1\n"
        "quadric 0 0 0\n-1 -1 -1 1 1 1\n1 0 0 0 1\n0 0 1 0 -1\n";
    Random random(3);
    for (int i = 0; i < 100; ++i) text += "sphere " + number(random) + "-1.5e-2 +7. .25\n";
    return {"prt",
            text,
            0,
            105,
            camera,
            "sphere x\n",
            "from ",
            {"from",   "at",      "up",      "angle",    "resolution",  "background",
             "light",  "surface", "polygon", "instance", "instance_of", "end_instance",
             "a",      "cone",    "sphere",  "hsphere",  "ring",        "quadric",
             "0 0 0",  "1",       "2",       "3",        "-1",          "1e308",
             "1e-308", "\n",      "#\n",     "n",        "1 2 3"}};
}

WholeScene sce() {
    const std::string camera =
        "eyepos 0 0 5\neyedir 0 0 -1\neyeup 0 1 0\nwdist 1\nfovy_deg 45\nnx 40\nny 30\n";
    std::string text = "sce1.0\r\n# generated\n" + camera +
                       "max_recursion 4\naasample 2\nbackground 0 .1 .2\nca .1 .2 .3\n{\n"
                       "rotate 60 1 1 0\ntranslate 1 2 3 # there\nscale 1 1 -1.6\n"
                       "pointlight 3 0 4 .8 .8 .6\narealight 0.3 0.8 0.8 0.6\n"
                       "object_flat nothing.obj\n}\n";
    Random random(12);
    for (int i = 0; i < 40; ++i) {
        text += "push_matrix\n\tscale " + number(random) + "1e-1 -2\n\tcr 1 0 0\n\tcp .5 .5 .5\n";
        text += "\tshininess 30\n\tball .5 1 2 3\n\tcylinder\n\ttriangle 0 0 0 1 0 " +
                number(random) + " 0 1 0\npop_matrix\n";
    }
    return {"sce",
            text + "end\nof it\n",
            1,  // its mesh does not exist
            120,
            camera,
            "ball x\n",
            "eyedir 0 0 0\n",
            {"{\n",
             "}\n",
             "push_matrix\n",
             "pop_matrix\n",
             "rotate",
             "translate",
             "ball",
             "cylinder\n",
             "scale",
             "triangle",
             "object_flat",
             "object_phong",
             ".",
             "pointlight",
             "arealight",
             "background",
             "eyepos",
             "eyedir",
             "eyeup",
             "fovy_deg",
             "nx",
             "aasample",
             "ca",
             "cr",
             "cp",
             "shininess",
             "0",
             "1",
             "-1 0 1",
             "2 0 0",
             "1e308",
             "-1e308",
             "1e-308",
             "1 2 3",
             "\n",
             "\n",
             "#\n",
             "max_recursion"}};
}

}  // namespace

const std::vector<WholeScene>& whole_scenes() {
    static const std::vector<WholeScene> scenes = {p3f(), nff(), prt(), sce()};
    return scenes;
}

}  // namespace etalon
