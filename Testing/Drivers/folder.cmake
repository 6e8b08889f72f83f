# Empties FOLDER, into which Mesa writes shaders: texts of an earlier build would stay.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
