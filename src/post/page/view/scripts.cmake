# The scripts of the page of `blocks view`, in the order in which they follow each other.
set(view_scripts state unpack numbers ticks colours geometry draft blocks joints bonds faces cracks forces arrows axes cursor legend
  table chart play save pointer controls keys start)
