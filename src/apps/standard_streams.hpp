// Standard output and error as files like others: what cannot be written is told.
#pragma once

namespace blocks::apps {

/// Takes the numbers of standard streams that were closed (`>&-`), so that no file of a
/// run gets them and what is printed later does not go into that file. To be called
/// before any file is opened.
void hold_standard_streams();

/// What the program ends with: `code`, unless it is 0 and something printed did not
/// reach standard output; then a message and the code of a file, 5.
int end_standard_output(int code);

}  // namespace blocks::apps
