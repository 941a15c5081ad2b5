// SPDX-License-Identifier: MIT
#include "model/foreign_format.h"

#include <algorithm>
#include <array>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

using namespace std::string_view_literals;

// How a model gets out of its format. assimp was tried with Debian's assimp-testmodels.
enum class Way { assimp, blender, new_blender, cad, own_program, surface };

struct ForeignFormat {
    std::string_view name;
    std::string_view extensions;             // with a blank behind each
    std::array<std::string_view, 2> begins;  // one of them, unless both are empty
    std::string_view within;                 // the head must hold this, too
    Way way;
};

// A format before those whose marks it has as well.
constexpr ForeignFormat kFormats[] = {
    {"FBX", ".fbx ", {"Kaydara FBX Binary"sv, "; FBX"sv}, {}, Way::assimp},
    {"COLLADA", ".dae ", {"<"sv}, "<COLLADA"sv, Way::assimp},
    {"3D Studio (3DS)", ".3ds ", {}, {}, Way::assimp},
    {"Blender's own (BLEND)", ".blend ", {"BLENDER"sv}, {}, Way::blender},
    {"USD", ".usd .usda .usdc ", {"PXR-USDC"sv, "#usda"sv}, {}, Way::new_blender},
    {"USDZ", ".usdz ", {"PK\3\4"sv}, ".usd"sv, Way::new_blender},
    {"3MF", ".3mf ", {"PK\3\4"sv}, "3D/3dmodel"sv, Way::assimp},
    {"IFC", ".ifc ", {"ISO-10303-21"sv}, "'IFC"sv, Way::cad},
    {"STEP", ".step .stp .p21 ", {"ISO-10303-21"sv}, {}, Way::cad},
    {"IGES", ".iges .igs ", {}, {}, Way::cad},
    {"BREP", ".brep .brp ", {"CASCADE Topology"sv, "DBRep_DrawableShape"sv}, {}, Way::cad},
    {"OFF", ".off ", {"OFF"sv, "COFF"sv}, {}, Way::assimp},
    {"X3D", ".x3d .x3dv .x3db ", {"<"sv}, "<X3D"sv, Way::assimp},
    {"VRML", ".wrl .vrml ", {"#VRML"sv}, {}, Way::blender},
    {"AMF", ".amf ", {"<"sv}, "<amf"sv, Way::assimp},
    {"Alembic", ".abc ", {"Ogawa"sv, "\x89HDF"sv}, {}, Way::new_blender},
    {"LightWave", ".lwo .lws ", {"FORM"sv}, "LWO"sv, Way::assimp},
    {"DirectX (X)", ".x ", {"xof "sv}, {}, Way::assimp},
    {"DXF", ".dxf ", {"AutoCAD Binary DXF"sv}, {}, Way::assimp},
    {"DWG", ".dwg ", {"AC10"sv}, {}, Way::cad},
    {"Quake's (MD2, MD3)", ".md2 .md3 ", {"IDP2"sv, "IDP3"sv}, {}, Way::assimp},
    {"Rhino (3DM)", ".3dm ", {"3D Geometry File Format"sv}, {}, Way::own_program},
    {"SketchUp (SKP)", ".skp ", {"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p"sv}, {}, Way::own_program},
    {"Maya", ".ma .mb ", {"//Maya ASCII"sv}, {}, Way::own_program},
    {"3ds Max", ".max ", {}, {}, Way::own_program},
    {"Cinema 4D", ".c4d ", {"QC4DC4D6"sv}, {}, Way::own_program},
    {"a point cloud (PCD)", ".pcd ", {"# .PCD"sv}, {}, Way::surface},
    {"a point cloud (LAS, E57, XYZ)", ".las .laz .e57 .xyz .pts ", {"LASF"sv, "ASTM-E57"sv}, {}, Way::surface},
    {"a cloud of Gaussian splats", ".splat .ksplat .spz ", {}, {}, Way::surface},
};

// These files are no models at all, whatever their names.
struct OtherFile {
    std::string_view begins, what;
};
constexpr OtherFile kOthers[] = {
    {"PK\3\4"sv, "this is a ZIP archive; unpack it, and name the model in it"},
    {"\x1F\x8B"sv, "this is packed by gzip; unpack it, and name what comes out"},
    {"\x28\xB5\x2F\xFD"sv, "this is packed by zstd; unpack it, and name what comes out"},
    {"7z\xBC\xAF"sv, "this is a 7z archive; unpack it, and name the model in it"},
    {"Rar!"sv, "this is a RAR archive; unpack it, and name the model in it"},
    {"\x89PNG"sv, "this is a picture; name the model that uses it"},
    {"\xFF\xD8\xFF"sv, "this is a picture; name the model that uses it"},
    {"\x89LUMI"sv, "this is a field already; draw it by 'lumi view' or 'lumi render'"},
    {"<!DOCTYPE html"sv, "this is a web page; download the file that it offers"},
    {"<html"sv, "this is a web page; download the file that it offers"},
    {"version https://git-lfs"sv, "Git LFS left a pointer here; fetch the file by 'git lfs pull'"},
};

bool begins_with(std::string_view head, std::string_view mark)
{
    return head.substr(0, mark.size()) == mark;
}

uint32_t number_at(std::string_view head, size_t place, size_t bytes)
{
    uint32_t value = 0;
    for (size_t k = bytes; k-- > 0;) value = value << 8 | static_cast<uint8_t>(head[place + k]);
    return value;
}

// A main chunk of a known kind of chunk.
bool is_3ds(std::string_view head)
{
    constexpr uint32_t kMain = 0x4D4D, kVersion = 0x0002, kEditor = 0x3D3D;
    if (head.size() < 8 || number_at(head, 0, 2) != kMain) return false;
    const uint32_t inner = number_at(head, 6, 2);
    return inner == kVersion || inner == kEditor;
}

// Lines of 80 columns, of which the 73rd names the section: S comes first.
bool is_iges(std::string_view head)
{
    constexpr size_t kSection = 72, kLine = 80;
    return head.size() > kLine && head[kSection] == 'S' && (head[kLine] == '\n' || head[kLine] == '\r') &&
           head.substr(0, kLine).find('\0') == std::string_view::npos;
}

bool has_marks_of(const ForeignFormat& format, std::string_view head)
{
    if (format.name == "3D Studio (3DS)") return is_3ds(head);
    if (format.name == "IGES") return is_iges(head);
    const bool begins = std::any_of(format.begins.begin(), format.begins.end(),
                                    [&](std::string_view mark) { return !mark.empty() && begins_with(head, mark); });
    return begins && head.find(format.within) != std::string_view::npos;
}

bool has_end_of(const ForeignFormat& format, const std::string& extension)
{
    return !extension.empty() && format.extensions.find(extension + " ") != std::string_view::npos;
}

std::string mend(Way way, const std::string& file)
{
    switch (way) {
        case Way::assimp:
            return "convert it by Debian's assimp-utils: assimp export '" + file + "' model.glb -fglb2";
        case Way::blender:
            return "open it in Blender, and use File > Export > glTF 2.0";
        case Way::new_blender:
            return "open it in Blender from blender.org, and use File > Export > glTF 2.0";
        case Way::cad:
            return "open it in a CAD program such as FreeCAD, and export glTF or STL";
        case Way::own_program:
            return "export glTF, STL or OBJ from the program that wrote it";
        case Way::surface:
            break;
    }
    return "only surfaces are read; make a mesh of it in a program such as MeshLab, and export PLY";
}

[[noreturn]] void refuse(const std::filesystem::path& file, const ForeignFormat& format)
{
    const std::string name(format.name);
    if (has_end_of(format, extension_of(file)))
        throw SceneError(
            at({file.string()}, "this is " + name + ", which is not read; " + mend(format.way, file.string())));
    const std::string end(format.extensions.substr(0, format.extensions.find(' ')));
    const std::string renamed = std::filesystem::path(file).replace_extension(end).string();
    throw SceneError(at({file.string()}, "this is " + name +
                                             ", whatever its name says, which is not read; let its name end in " + end +
                                             ", and " + mend(format.way, renamed)));
}

// Without a byte order mark and blanks.
std::string_view first_word_on(std::string_view head)
{
    if (begins_with(head, "\xEF\xBB\xBF"sv)) head.remove_prefix(3);
    return head.substr(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
}

}  // namespace

std::string extension_of(const std::filesystem::path& file)
{
    return in_small_letters(file.extension().string());
}

void refuse_foreign_model(const std::filesystem::path& file, std::string_view head)
{
    const std::string extension = extension_of(file);
    const std::string_view text = first_word_on(head);
    for (const ForeignFormat& format : kFormats)
        if (has_marks_of(format, format.begins[0] == "<"sv ? text : head)) refuse(file, format);
    for (const ForeignFormat& format : kFormats)
        if (has_end_of(format, extension)) refuse(file, format);
    for (const OtherFile& other : kOthers)
        if (begins_with(head, other.begins)) throw SceneError(at({file.string()}, std::string(other.what)));
}

}  // namespace lumi::baker
