#include "tests/faults/small_bombs.h"

#include "tests/app/run_program.h"

namespace etalon::test {
namespace {

/// Converts hexadecimal digits to bytes.
std::string bytes(const std::string& digits) {
    std::string result;
    for (std::size_t i = 0; i < digits.size(); i += 2) {
        result += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    }
    return result;
}

// Headers of images of 65535 and more pixels per side, followed by little data.
const std::string png_rows = bytes(
    "89504e470d0a1a0a0000000d494844520000ffff0000ffff1006000000e69505130000002a49444154789cedc13101"
    "00"
    "0000c2a0f54f6d0d0fa00000000000000000000000000000000000000078304e2000012e9fa136");

const std::string png_interlaced = bytes(
    "89504e470d0a1a0a0000000d494844520000ffff0000ffff1006000001919235850000002a49444154789cedc13101"
    "00"
    "0000c2a0f54f6d0d0fa00000000000000000000000000000000000000078304e2000012e9fa136");

const std::string exr_wide = bytes(
    "762f3101020000006368616e6e656c730063686c697374004900000041000200000000000000010000000100000042"
    "00"
    "0200000000000000010000000100000047000200000000000000010000000100000052000200000000000000010000"
    "00"
    "0100000000636f6d7072657373696f6e00636f6d7072657373696f6e0001000000036461746157696e646f7700626f"
    "78"
    "326900100000000000000000000000ffff0000ffff0000646973706c617957696e646f7700626f7832690010000000"
    "00"
    "00000000000000ffff0000ffff00006c696e654f72646572006c696e654f72646572000100000000706978656c4173"
    "70"
    "656374526174696f00666c6f617400040000000000803f73637265656e57696e646f7743656e746572007632660008"
    "00"
    "0000000000000000000073637265656e57696e646f77576964746800666c6f617400040000000000803f0000000000"
    "00"
    "0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000"
    "00"
    "0000000000000000000000");

const std::string exr_endless = bytes(
    "762f3101020000006368616e6e656c730063686c697374004900000041000200000000000000010000000100000042"
    "00"
    "0200000000000000010000000100000047000200000000000000010000000100000052000200000000000000010000"
    "00"
    "0100000000636f6d7072657373696f6e00636f6d7072657373696f6e0001000000036461746157696e646f7700626f"
    "78"
    "326900100000000000000000000000ff933577ff933577646973706c617957696e646f7700626f7832690010000000"
    "00"
    "00000000000000ff933577ff9335776c696e654f72646572006c696e654f72646572000100000000706978656c4173"
    "70"
    "656374526174696f00666c6f617400040000000000803f73637265656e57696e646f7743656e746572007632660008"
    "00"
    "0000000000000000000073637265656e57696e646f77576964746800666c6f617400040000000000803f0000000000"
    "00"
    "0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000"
    "00"
    "0000000000000000000000");

const std::string jpeg = bytes(
    "ffd8ffdb00430001010101010101010101010101010101010101010101010101010101010101010101010101010101"
    "01"
    "0101010101010101010101010101010101010101010101ffc0001108ffdcffdc03011100021100031100ffc2ffd9");

const std::string radiance = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000000 +X 1000000000\n";

std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
}

/// Returns a PBRT scene with `options` before WorldBegin and `world` after it.
SmallBomb pbrt(const std::string& name, const std::string& options, const std::string& world,
               const std::string& file = {}, const std::string& content = {}) {
    return {name, "pbrt",
            "LookAt 0 0 -5 0 0 0 0 1 0 Camera \"perspective\"\n" +
                (options.find("Film") == options.npos
                     ? "Film \"image\" \"integer xresolution\" 16 \"integer yresolution\" 16\n"
                     : std::string()) +
                options + "\nWorldBegin LightSource \"point\"\n" + world + "\nWorldEnd\n",
            file, content};
}

const std::string sphere = "Shape \"sphere\" ";

std::string film(const std::string& x, const std::string& y) {
    return "Film \"image\" \"integer xresolution\" " + x + " \"integer yresolution\" " + y + " ";
}

/// Returns a scene in which each object contains `each` instances of the previous one.
std::string doubling(int levels, int each) {
    std::string text = "ObjectBegin \"a\" " + sphere + "ObjectEnd\n";
    char name = 'a';
    for (int i = 0; i < levels; ++i, ++name) {
        text += std::string("ObjectBegin \"") + static_cast<char>(name + 1) + "\"" +
                repeated(std::string("ObjectInstance\"") + name + "\"", each) + "ObjectEnd\n";
    }
    return text + "ObjectInstance \"" + name + "\"";
}

/// Returns textures or materials, each of which refers twice to the previous one.
std::string mixed_textures(int levels) {
    std::string text = "Texture \"a\" \"float\" \"constant\"\n";
    char name = 'a';
    for (int i = 0; i < levels; ++i, ++name) {
        text += std::string("Texture \"") + static_cast<char>(name + 1) +
                "\" \"float\" \"scale\" \"texture tex1\" \"" + name + "\" \"texture tex2\" \"" +
                name + "\"\n";
    }
    return text + "Material \"matte\" \"texture sigma\" \"" + name + "\" " + sphere;
}

std::string mixed_materials(int levels) {
    std::string text = "MakeNamedMaterial \"a\" \"string type\" \"matte\"\n";
    char name = 'a';
    for (int i = 0; i < levels; ++i, ++name) {
        const std::string before = std::string(" \"") + name + "\"";
        text += std::string("MakeNamedMaterial \"") + static_cast<char>(name + 1) +
                "\" \"string type\" \"mix\" \"string namedmaterial1\"" + before +
                " \"string namedmaterial2\"" + before + "\n";
    }
    return text + "NamedMaterial \"" + name + "\" " + sphere;
}

const std::string box_of_mirrors =
    "Material \"mirror\" \"rgb Kr\" [1 1 1] Shape \"sphere\" \"float radius\" 100 ";
const std::string glass = "Material \"glass\" ";

const std::string ply_header =
    "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty double x\nproperty "
    "double y\nproperty double z\nelement face 4000000000\nproperty list uint int "
    "vertex_indices\nend_header\n";

std::string p3f(const std::string& statements, const std::string& resolution = "16 16",
                const std::string& samples = "1") {
    return "accel bvh\nspp " + samples +
           "\nbclr 0 0 0\ncamera\neye 0 1 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither "
           "0.01\nresolution " +
           resolution +
           "\naperture 0\nfocal 1\nlight punctual 3 5 4 1 1 1\nmat 1 1 1 1 1 1 1 0 10 0 1\n" +
           statements + "\n";
}

const std::string nff_view =
    "v from 2 1 2 at 0 0 0 up 0 0 1 angle 45 hither 0 resolution 16 16\nl 4 3 2\n"
    "f 1 1 1 0.8 0 1 0 0\ns 0 0 0 0.5\n";
const std::string prt_view =
    "from 2 2 6 at 2 1 0 up 0 1 0 angle 40 resolution 16 16\nlight 6 6 8\n"
    "surface 0 0 0 0 0 0 0 0 0 .2 .2 0 .5 .5 0 0 0 0 0\nsphere 0 0 0 1\n";

std::vector<SmallBomb> of_pixels_and_samples() {
    return {
        {"the largest image", "p3f", p3f("s 0 0 0 1", "65536 65536")},
        {"an image larger than any", "p3f", p3f("s 0 0 0 1", "1000000000 1000000000")},
        {"samples without end", "p3f", p3f("s 0 0 0 1", "16 16", "99999999999")},
        {"a million samples", "p3f", p3f("s 0 0 0 1", "400 400", "1048576")},
        {"a wide image", "nff",
         "v from 2 1 2 at 0 0 0 up 0 0 1 angle 45 hither 0 resolution 2000000000 2000000000\n"
         "l 4 3 2\nf 1 1 1 0.8 0 1 0 0\ns 0 0 0 0.5\n"},
        {"a wide image", "prt",
         "from 2 2 6 at 2 1 0 up 0 1 0 angle 40 resolution 65536 65536\nlight 6 6 8\n"
         "surface 0 0 0 0 0 0 0 0 0 .2 .2 0 .5 .5 0 0 0 0 0\nsphere 0 0 0 1\n"},
        {"a wide image", "sce", "nx 65536\nny 65536\nball 1 0 0 -5\nend\n"},
        {"samples squared", "sce", "nx 65536\nny 1\naasample 2000000000\nball 1 0 0 -5\nend\n"},
        pbrt("the largest film", film("65536", "65536"), sphere),
        pbrt("a film larger than any", film("2147483647", "2147483647"), sphere),
        pbrt("a billion samples", "Sampler \"halton\" \"integer pixelsamples\" 1000000000", sphere),
        pbrt("samples that overflow",
             "Sampler \"stratified\" \"integer xsamples\" 65537 \"integer ysamples\" 65537",
             sphere),
        pbrt("a filter as wide as the world",
             "PixelFilter \"gaussian\" \"float xwidth\" 1e9 \"float ywidth\" 1e9", sphere),
        pbrt("a filter as wide as the image",
             film("500", "500") + "PixelFilter \"sinc\" \"float xwidth\" 500 \"float ywidth\" 500",
             sphere),
        pbrt("occlusion by a billion rays",
             "Integrator \"ambientocclusion\" \"integer nsamples\" 2000000000", sphere),
        pbrt("a light that asks for a billion samples", "Integrator \"directlighting\"",
             "AttributeBegin AreaLightSource \"diffuse\" \"integer nsamples\" 2000000000 " +
                 sphere + "AttributeEnd " + sphere),
        pbrt("a photon map of billions",
             "Integrator \"sppm\" \"integer photonsperiteration\" 2000000000 \"integer "
             "numiterations\" 2000000000",
             sphere),
        pbrt("mutations of billions", "Integrator \"mlt\" \"integer bootstrapsamples\" 2000000000",
             sphere),
    };
}

std::vector<SmallBomb> of_paths() {
    const std::string deep = " \"integer maxdepth\" 2000000000 ";
    const std::string deep_path = "Integrator \"path\"" + deep + "\"float rrthreshold\" 0";
    return {
        {"mirrors without end", "p3f", p3f("s 0 0 0 -100"), {}, {}},
        pbrt("paths without end", deep_path, box_of_mirrors),
        pbrt("a tree of rays without end", "Integrator \"whitted\"" + deep,
             glass + sphere +
                 "Shape \"sphere\" \"float radius\" 2 Shape \"sphere\" \"float radius\" 90"),
        pbrt("trees of rays at each mirror", "Integrator \"directlighting\"" + deep,
             glass + sphere + "Shape \"sphere\" \"float radius\" 2"),
        pbrt("a white furnace", deep_path,
             "Material \"matte\" \"rgb Kd\" [1 1 1] Shape \"sphere\" \"float radius\" 100"),
        pbrt("a thick fog", "Integrator \"volpath\"" + deep,
             "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [1e9 1e9 1e9] "
             "\"rgb sigma_a\" [0 0 0]\nMediumInterface \"m\" \"\" Material \"\" " +
                 sphere),
        pbrt("a thick grid", "Integrator \"volpath\"" + deep,
             "MakeNamedMedium \"m\" \"string type\" \"heterogeneous\" \"float density\" [1e9] "
             "\"rgb sigma_s\" [1e9 1e9 1e9]\nMediumInterface \"m\" \"\" Material \"\" " +
                 sphere),
        {"mirrors that face each other", "sce",
         "nx 16\nny 16\nmax_recursion 2000000000\ncp 1 1 1\nball 1000 0 0 0\nend\n"},
    };
}

std::vector<SmallBomb> of_nesting() {
    return {
        pbrt("a file in itself", "", "Include \"bomb.pbrt\""),
        pbrt("two files in each other", "", "Include \"other\"", "other", "Include \"bomb.pbrt\""),
        pbrt("a file that includes many times", "", repeated("Include \"other\"\n", 50), "other",
             repeated("Include \"bomb.pbrt\"\n", 45)),
        pbrt("a device without end", "", "Include \"/dev/zero\""),
        pbrt("objects that hold four of the one before", "", doubling(8, 4)),
        pbrt("objects that hold two of the one before", "", doubling(12, 2)),
        pbrt("an object in itself", "",
             "ObjectBegin \"a\" " + sphere +
                 "ObjectInstance \"a\" ObjectInstance \"a\" ObjectEnd ObjectInstance \"a\""),
        pbrt("attributes in attributes", "", repeated("AttributeBegin\n", 50) + sphere),
        pbrt("brackets in brackets", "", "Shape \"sphere\" \"float radius\" " + repeated("[", 800)),
        pbrt("textures of textures", "", mixed_textures(9)),
        pbrt("materials of materials", "", mixed_materials(5)),
        {"blocks in blocks", "sce", repeated("{\npush_matrix\n", 60) + "ball 1 0 0 -5\nend\n"},
        {"references to an instance", "prt",
         "instance a " + repeated("sphere 0 0 0 1 ", 30) + "end_instance\n" + prt_view +
             repeated("instance_of a 1 1 1\n", 20)},
        {"a mesh that is a device", "sce", "object_flat /dev/zero\nball 1 0 0 -5\nend\n"},
        {"a mesh that is the scene", "sce", "object_flat bomb.sce\nball 1 0 0 -5\nend\n"},
    };
}

std::vector<SmallBomb> of_counts() {
    return {
        {"a billion corners", "p3f", p3f("p 1000000000 0 0 0 1 0 0 0 1 0")},
        {"a mesh of billions", "p3f", p3f("mesh 2000000000 2000000000 0 0 0 1 0 0 0 1 0 1 2 3")},
        {"a light of a billion points", "p3f",
         p3f("light quad 0 5 0 1 1 1 1 5 0 0 5 1 2000000000\ns 0 0 0 1", "16 16", "0")},
        {"a light of as many points as can be", "p3f",
         p3f("light quad 0 5 0 1 1 1 1 5 0 0 5 1 65536\ns 0 0 0 1", "400 400", "0")},
        {"a billion corners", "nff", nff_view + "p 4000000000 0 0 0 1 0 0 0 1 0\n"},
        {"a billion corners", "prt", prt_view + "polygon 4000000000 0 0 0 1 0 0 0 1 0\n"},
        {"spheres of all sizes in a grid", "p3f",
         "accel grid\n" +
             p3f("s 0 0 0 1e-30\ns 1 1 1 1e-30\ns 1e30 0 0 1e29\nbox -1e30 -1 -1 1e30 1 1")},
    };
}

SmallBomb subdivided(const std::string& times, const std::string& levels) {
    return pbrt("a triangle subdivided " + times + " times", "",
                "Shape \"loopsubdiv\" \"integer nlevels\" " + levels +
                    " \"point P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]");
}

std::vector<SmallBomb> of_counts_in_pbrt() {
    return {
        subdivided("twelve", "12"),
        subdivided("thirty", "30"),
        subdivided("two billion", "2000000000"),
        pbrt("a heightfield of billions", "",
             "Shape \"heightfield\" \"integer nu\" 100000 \"integer nv\" 100000 \"float Pz\" [0 1 "
             "2 3]"),
        pbrt("a surface of billions of knots", "",
             "Shape \"nurbs\" \"integer nu\" 2000000000 \"integer nv\" 2000000000 \"integer "
             "uorder\" "
             "2000000000 \"integer vorder\" 4 \"float uknots\" [0 1] \"float vknots\" [0 1] "
             "\"point P\" "
             "[0 0 0]"),
        pbrt("a curve cut without end", "",
             "Shape \"curve\" \"integer splitdepth\" 2000000000 \"point P\" [0 0 0 1 0 0 1 1 0 0 1 "
             "1]"),
        pbrt("a mesh of a vertex that is not there", "",
             "Shape \"trianglemesh\" \"point P\" [0 0 0] \"integer indices\" [0 1 2147483647]"),
        pbrt(
            "a grid of 10^15 cells", "Integrator \"volpath\"",
            "MakeNamedMedium \"m\" \"string type\" \"heterogeneous\" \"integer nx\" 100000 "
            "\"integer "
            "ny\" 100000 \"integer nz\" 100000 \"float density\" [1]\nMediumInterface \"m\" \"\" " +
                sphere),
        pbrt("a mesh of a header alone", "", "Shape \"plymesh\" \"string filename\" \"file\"",
             "file", ply_header),
        pbrt("noise of a billion octaves", "",
             "Texture \"t\" \"float\" \"fbm\" \"integer octaves\" 2000000000 Material \"matte\" "
             "\"texture sigma\" \"t\" \"texture bumpmap\" \"t\" " +
                 sphere),
        pbrt("wrinkles of a billion octaves", "",
             "Texture \"t\" \"float\" \"wrinkled\" \"integer octaves\" 2000000000 \"float "
             "roughness\" 1 "
             "Material \"matte\" \"texture sigma\" \"t\" " +
                 sphere),
        pbrt("a lens that is a device", "Camera \"realistic\" \"string lensfile\" \"/dev/zero\"",
             sphere),
        pbrt("a measured material that is a device", "",
             "Material \"fourier\" \"string bsdffile\" \"/dev/zero\" " + sphere),
        pbrt("a spectrum that is a device", "",
             "Material \"matte\" \"spectrum Kd\" \"/dev/zero\" " + sphere),
    };
}

SmallBomb texture(const std::string& name, const std::string& extension, const std::string& image) {
    return pbrt(name, "",
                "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"image." + extension +
                    "\" Material \"matte\" \"texture Kd\" \"t\" " + sphere,
                "image." + extension, image);
}

std::vector<SmallBomb> of_images() {
    return {
        texture("a PNG of a header", "png", png_rows),
        texture("an interlaced PNG of a header", "png", png_interlaced),
        texture("an EXR of a header", "exr", exr_wide),
        texture("an EXR larger than any", "exr", exr_endless),
        texture("a JPEG of a header", "jpg", jpeg),
        texture("a Radiance image of a header", "hdr", radiance),
        texture("an image that is a device", "tga", ""),
        pbrt("a sky of a header", "",
             "LightSource \"infinite\" \"string mapname\" \"image.exr\" " + sphere, "image.exr",
             exr_wide),
        pbrt("a slide of a header", "",
             "LightSource \"projection\" \"string mapname\" \"image.png\" " + sphere, "image.png",
             png_rows),
        pbrt("an alpha of a header", "",
             "Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"image.png\" Shape "
             "\"trianglemesh\" \"texture alpha\" \"t\" \"point P\" [0 0 0 1 0 0 0 1 0] \"integer "
             "indices\" [0 1 2]",
             "image.png", png_interlaced),
    };
}

}  // namespace

std::vector<SmallBomb> small_bombs() {
    std::vector<SmallBomb> all;
    for (const auto& some : {of_pixels_and_samples(), of_paths(), of_nesting(), of_counts(),
                             of_counts_in_pbrt(), of_images()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

}  // namespace etalon::test
