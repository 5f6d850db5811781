namespace trembler {}
