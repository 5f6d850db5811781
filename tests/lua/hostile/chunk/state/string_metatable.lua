-- tries to change the methods of all strings
-- expect: error
getmetatable('').__index = function() return 'mine' end
