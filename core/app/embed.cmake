# cmake -DOUTPUT=FILE.c "-DFOLDERS=FOLDER;..." -P embed.cmake
# Writes every file of the folders into FILE.c, as the table of app/sdk_files.h.
foreach(folder ${FOLDERS})
  get_filename_component(parent ${folder} DIRECTORY)
  file(GLOB files RELATIVE ${parent} ${folder}/*)
  foreach(file ${files})
    file(READ ${parent}/${file} bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    string(MAKE_C_IDENTIFIER ${file} name)
    string(APPEND arrays "static const unsigned char ${name}[] = {${bytes}};\n")
    string(APPEND rows "    {\"${file}\", ${name}, sizeof ${name}},\n")
  endforeach()
endforeach()
file(WRITE ${OUTPUT} "#include \"app/sdk_files.h\"\n\n${arrays}\n"
  "const SdkFile SDK_FILES[] = {\n${rows}};\n"
  "const size_t N_SDK_FILES = sizeof SDK_FILES / sizeof *SDK_FILES;\n")
