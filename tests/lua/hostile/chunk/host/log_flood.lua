-- tries to flood the log
-- expect: limit
while true do log('again') end
