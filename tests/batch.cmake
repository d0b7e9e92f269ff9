# cmake -DFILES=… -DTO=… -P batch.cmake: one source of several tests. Headers come first, so that they are in no namespace;
# then each file in a namespace of its own, so that names of one mean nothing to the others.
foreach(file IN LISTS FILES)
  file(STRINGS ${file} lines REGEX "^#include")
  list(APPEND headers ${lines})
  get_filename_component(name ${file} NAME_WE)
  string(APPEND tests "namespace ${name} {\n#include \"${file}\"\n}\n")
endforeach()
list(REMOVE_DUPLICATES headers)
list(JOIN headers "\n" headers)
file(WRITE ${TO} "${headers}\n${tests}")
