// Treats standard output and error like files: a failed write is reported.
#pragma once

namespace blocks::apps {

/// Occupies the descriptors of standard streams that are closed (`>&-`). Otherwise a
/// file of the run could get such a descriptor, and printed text would go into it. Call
/// this before any file is opened.
void hold_standard_streams();

/// Lets the program continue when the reader of its standard output ends (`| head`), so
/// that a run finishes its files.
void outlive_broken_pipes();

/// Returns the exit code of the program. It is `code`, unless `code` is 0 and standard
/// output could not be written; then a message is printed and the result is 5, file
/// error. If the reader of standard output has ended, SIGPIPE ends the program here
/// without a message, as it ends a filter.
int end_standard_output(int code);

}  // namespace blocks::apps
