-- tries to jump past the counter by its name
-- expect: refused
::__count:: goto __count
