# cmake -D OUT=file.cpp -D FOLDER=assets/scenes -D "NAMES=a;b" -P embed.cmake
# Writes the scenes as bytes: string literals are limited in length by the standard.
function(bytes_of file out)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
  string(REGEX REPLACE "((.......){20})" "\\1\n" bytes "${bytes}")
  set(${out} "${bytes}" PARENT_SCOPE)
endfunction()

set(arrays "")
set(entries "")
foreach(name IN LISTS NAMES)
  string(MAKE_C_IDENTIFIER ${name} id)
  foreach(kind obj mtl)
    bytes_of(${FOLDER}/${name}.${kind} bytes)
    string(APPEND arrays "constexpr char ${id}_${kind}[] = {\n${bytes}};\n")
  endforeach()
  string(APPEND entries "    {\"${name}\", {${id}_obj, sizeof ${id}_obj}, {${id}_mtl, sizeof ${id}_mtl}},\n")
endforeach()
file(WRITE ${OUT}.new "// Made from ${NAMES} by embed.cmake.
#include \"scene/bundled.h\"

namespace penumbra {

namespace {
${arrays}
constexpr BundledScene scenes[] = {
${entries}};
} // namespace

std::span<const BundledScene> bundled_scenes() { return scenes; }

} // namespace penumbra
")
file(COPY_FILE ${OUT}.new ${OUT} ONLY_IF_DIFFERENT)
file(REMOVE ${OUT}.new)
