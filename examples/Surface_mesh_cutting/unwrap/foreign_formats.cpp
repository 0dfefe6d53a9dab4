#include "foreign_formats.h"

#include "file_extension.h"

#include <cstddef>

namespace {

struct Sign
{
  std::string_view text, format;
};

constexpr Sign beginnings[] = {
  {"Kaydara FBX Binary", "FBX"}, {"; FBX", "FBX"}, {"BLENDER", "a Blender file"}, {"ISO-10303-21", "STEP"},
  {"#usda ", "USD"}, {"PXR-USDC", "USD"}, {"#VRML", "VRML"}, {"#X3D", "X3D"}, {"xof 0", "a DirectX mesh"},
  {"Ogawa\xFF", "Alembic"}, {"\x89HDF\r\n", "HDF5"}, {"//Maya ASCII", "a Maya scene"},
  {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", "a scene of 3ds Max or another program"}, {"# vtk DataFile", "VTK"},
  {"$MeshFormat", "Gmsh"}};

constexpr Sign archives[] = {
  {"PK\x03\x04", "a ZIP archive"}, {"\x1F\x8B\x08", "compressed by gzip"}, {"BZh", "compressed by bzip2"},
  {"7z\xBC\xAF\x27\x1C", "a 7z archive"}, {"Rar!\x1A\x07", "a RAR archive"}, {"\x28\xB5\x2F\xFD", "compressed by Zstandard"},
  {"\xFD\x37zXZ", "compressed by xz"}};

constexpr Sign endings[] = {
  {".fbx", "FBX"}, {".3mf", "3MF"}, {".blend", "a Blender file"}, {".dae", "COLLADA"}, {".step", "STEP"}, {".stp", "STEP"},
  {".iges", "IGES"}, {".igs", "IGES"}, {".usd", "USD"}, {".usda", "USD"}, {".usdc", "USD"}, {".usdz", "USD"},
  {".max", "a 3ds Max scene"}, {".ma", "a Maya scene"}, {".mb", "a Maya scene"}, {".c4d", "a Cinema 4D scene"},
  {".skp", "a SketchUp model"}, {".x", "a DirectX mesh"}, {".3ds", "3DS"}, {".abc", "Alembic"}, {".wrl", "VRML"},
  {".vrml", "VRML"}, {".x3d", "X3D"}, {".lwo", "a LightWave object"}, {".lxo", "a Modo scene"}, {".amf", "AMF"},
  {".dxf", "DXF"}, {".dwg", "DWG"}, {".3dm", "a Rhino model"}, {".ztl", "a ZBrush tool"}, {".zpr", "a ZBrush project"},
  {".hip", "a Houdini scene"}, {".sldprt", "a SolidWorks part"}, {".f3d", "a Fusion design"}, {".ifc", "IFC"},
  {".brep", "BREP"}, {".msh", "Gmsh"}, {".vtk", "VTK"}, {".vtu", "VTK"}, {".vrm", "VRM"}, {".mdl", "MDL"}, {".zip", "an archive"}};

constexpr std::string_view git_lfs = "version https://git-lfs.github.com/spec/";

// Those that are archives of other files.
std::string_view format_in_archive(std::string_view bytes)
{
  const std::string_view names = bytes.substr(0, 4096);
  return names.find("3D/") != std::string_view::npos || bytes.find("3D/3dmodel.model") != std::string_view::npos ? "3MF"
       : names.find(".usd") != std::string_view::npos ? "USD" : "";
}

template <std::size_t size>
std::string_view find(const Sign (&signs)[size], std::string_view bytes)
{
  for(const Sign& sign : signs)
    if(bytes.substr(0, sign.text.size()) == sign.text)
      return sign.format;
  return {};
}

std::string refusal(std::string_view format)
{
  return "the file is " + std::string(format) + ", which is not read: export OBJ or GLB from the program that made it";
}

} // namespace

std::string refuse_foreign_content(std::string_view bytes)
{
  constexpr std::size_t size_of_start = 1024;
  if(bytes.substr(0, git_lfs.size()) == git_lfs)
    return "the file only stands for one in Git LFS: 'git lfs pull' brings that one";
  if(const std::string_view format = find(beginnings, bytes); !format.empty())
    return refusal(format);
  if(const std::string_view archive = find(archives, bytes); !archive.empty())
  {
    const std::string_view format = format_in_archive(bytes);
    return !format.empty() ? refusal(format) : "the file is " + std::string(archive) + ": unpack it first";
  }
  if(bytes.substr(0, size_of_start).find("<COLLADA") != std::string_view::npos)
    return refusal("COLLADA");
  if(bytes.substr(0, size_of_start).find("<X3D") != std::string_view::npos)
    return refusal("X3D");
  return {};
}

std::string refuse_content(std::string_view bytes)
{
  if(const std::string reason = refuse_foreign_content(bytes); !reason.empty())
    return reason;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if(first < bytes.size() && bytes[first] == '{' && bytes.find("\"asset\"") != std::string_view::npos)
    return "the file is glTF in text, which may refer to other files: its name has to end in .gltf";
  return {};
}

std::string refuse_ending(const std::string& path)
{
  const std::string ending = extension_of(path);
  for(const Sign& sign : endings)
    if(ending == sign.text)
      return refusal(sign.format);
  return {};
}
