# Writes OUTPUT, a C++ file that holds the text of the files FILES (a list joined by commas).
string(REPLACE "," ";" files "${FILES}")
set(entries "")
foreach(file ${files})
    get_filename_component(name ${file} NAME)
    file(READ ${file} text)
    string(APPEND entries "        {\"${name}\", R\"schema(${text})schema\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"schemas/builtin_schemas.h\"

namespace schemas {

const std::vector<BuiltInSchema>& builtInSchemas() {
    static const std::vector<BuiltInSchema> files = {
${entries}    };
    return files;
}

} // namespace schemas
")
