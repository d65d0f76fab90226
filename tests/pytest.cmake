# add_pytest(NAME FOLDER): the Python tests of a folder as one test, run by Debian's own interpreter.
function(add_pytest name folder)
  add_test(NAME ${name}
    COMMAND /usr/bin/python3 -m pytest -p no:cacheprovider ${folder} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES
    ENVIRONMENT "PYTHONPATH=${PROJECT_SOURCE_DIR}/pkg;PYTHONDONTWRITEBYTECODE=1;OMP_NUM_THREADS=1" TIMEOUT 600)
endfunction()
