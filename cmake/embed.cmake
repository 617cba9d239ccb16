# Writes a text file as the source of a std::string_view, for pointmill_embed().
cmake_minimum_required(VERSION 3.22)

file(READ ${FILE} text)
string(FIND "${text}" ")embedded\"" end)
if(NOT end EQUAL -1)
  message(FATAL_ERROR "${FILE} holds what ends the literal")
endif()
file(WRITE ${SOURCE} "#include <string_view>

namespace pointmill::${NAMESPACE} {
extern const std::string_view ${NAME};
const std::string_view ${NAME}(R\"embedded(")
file(APPEND ${SOURCE} "${text}")
file(APPEND ${SOURCE} ")embedded\");
} // namespace pointmill::${NAMESPACE}
")
