-- tries to hide the beginning of a loop behind a comment
-- expect: limit
while true --[==[ do end ]==] do --[[ end
]] end
